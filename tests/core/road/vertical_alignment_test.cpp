#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "streetgen/error.hpp"
#include "streetgen/road_standard.hpp"
#include "streetgen/vertical_alignment.hpp"

namespace streetgen {
namespace vertical_alignment_test {

TEST(VerticalAlignment, AParabolaLeavesItsPointByTheMiddleOrdinate) {
  // R dg^2 / 8, below a crest and above a sag.
  for (double last : {0.0, 30.0}) {
    const auto pieces = vertical_alignment({{0, 0, 0}, {300, 15, 2000}, {600, last, 0}});
    const double change = (last - 15) / 300 - 0.05;
    EXPECT_NEAR(grade_place(pieces, 300).height - 15,
                std::copysign(2000 * change * change / 8, change), 1e-9);
  }
}

TEST(VerticalAlignment, HeightsAndGradesAreContinuous) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> height(-5, 5);
  for (int round = 0; round < 200; ++round) {
    std::vector<GradePoint> points;
    for (int i = 0; i < 9; ++i) points.push_back({i * 100.0, height(random), 400});
    const auto pieces = vertical_alignment(points);
    for (std::size_t i = 1; i < pieces.size(); ++i) {
      const double at = pieces[i].start_abscissa, run = at - pieces[i - 1].start_abscissa;
      const GradePiece& before = pieces[i - 1];
      EXPECT_NEAR(before.height + (before.grade + before.bend * run / 2) * run, pieces[i].height,
                  1e-9);
      EXPECT_NEAR(before.grade + before.bend * run, pieces[i].grade, 1e-9);
    }
    EXPECT_NEAR(grade_place(pieces, 800).height, points.back().height, 1e-9);
  }
}

TEST(VerticalAlignment, PointsOutOfOrderAndParabolasThatOverlapAreRefused) {
  EXPECT_THROW(vertical_alignment({{0, 0, 0}, {100, 5, 0}, {50, 5, 0}}), Error);
  EXPECT_THROW(vertical_alignment({{0, 0, 0}, {100, 5, 3000}, {200, 0, 0}}), Error);
  EXPECT_THROW(vertical_alignment({{0, NAN, 0}, {100, 5, 0}}), Error);
  EXPECT_TRUE(vertical_alignment({{0, 3, 0}}).empty());
}

TEST(RoadStandard, TheLeastRadiusIsThatOfTheNorm) {
  // V^2 / (127 (e + f)) with the friction of JAE P3/94.
  for (const auto& [speed, radius] :
       {std::pair{40.0, 55.0}, {60.0, 130.0}, {90.0, 320.0}, {120.0, 700.0}, {140.0, 1200.0}})
    EXPECT_NEAR(least_radius(speed, 0.07, -1), radius, 1e-9);
  EXPECT_NEAR(least_radius(60, 0.04, 0.1), 3600 / (127 * 0.14), 1e-9);
  EXPECT_THROW(least_radius(60, -0.1, 0.05), Error);
}

}  // namespace vertical_alignment_test
}  // namespace streetgen
