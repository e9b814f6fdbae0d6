#include "streetgen/height_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace streetgen {
namespace height_curve_test {

double height_at(const HeightPiece& p, double s) {
  const double on = s - p.s;
  return p.a + on * (p.b + on * (p.c + on * p.d));
}
double grade_at(const HeightPiece& p, double s) {
  const double on = s - p.s;
  return p.b + on * (2 * p.c + 3 * on * p.d);
}

// A grade of 5 %, rounded by a parabola of that length, and one of -3 %.
double crest(double s, double length) {
  const double on = std::clamp(s - 100, 0.0, length);
  return 0.05 * s - 0.08 * on * on / (2 * length) - 0.08 * std::max(0.0, s - 100 - length);
}

TEST(HeightCurve, HasFewPiecesOfGradesAndParabolas) {
  for (const double length : {40.0, 80.0, 160.0}) {
    std::vector<double> stations, heights;
    for (double s = 0; s <= 400; s += 5) {
      stations.push_back(s);
      heights.push_back(crest(s, length));
    }
    const auto pieces = height_curve(stations, heights, 0.01);
    EXPECT_LE(pieces.size(), 5u);
    for (std::size_t i = 1; i < pieces.size(); ++i) {
      EXPECT_NEAR(height_at(pieces[i - 1], pieces[i].s), pieces[i].a, 1e-9);
      EXPECT_NEAR(grade_at(pieces[i - 1], pieces[i].s), pieces[i].b, 1e-9);
    }
    EXPECT_NEAR(pieces.front().b, 0.05, 1e-9);
    EXPECT_NEAR(grade_at(pieces.back(), 400), -0.03, 1e-9);
    for (const double s : stations) {
      auto piece = std::find_if(pieces.rbegin(), pieces.rend(),
                                [&](const HeightPiece& p) { return p.s <= s; });
      EXPECT_NEAR(height_at(*piece, s), crest(s, length), 0.01 + 1e-9);
    }
  }
}

// A break between long straight grades is none that a curve passes by a centimetre.
TEST(HeightCurve, KeepsTheBreaksOfLongGrades) {
  const auto pieces = height_curve({0, 50, 100}, {0, 5, 0}, 0.01);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_NEAR(pieces[0].b, 0.1, 1e-12);
  EXPECT_NEAR(pieces[0].c, 0, 1e-12);
  EXPECT_NEAR(pieces[1].b, -0.1, 1e-12);
}

TEST(HeightCurve, PassesRandomHeights) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> step(0.5, 20), climb(-0.1, 0.1);
  for (int i = 0; i < 200; ++i) {
    std::vector<double> stations{0}, heights{10};
    for (int k = 0; k < 2 + i % 40; ++k) {
      stations.push_back(stations.back() + step(random));
      heights.push_back(heights.back() + climb(random) * (stations.back() - *(stations.end() - 2)));
    }
    const auto pieces = height_curve(stations, heights, 0.01);
    ASSERT_LT(pieces.size(), stations.size());
    for (std::size_t k = 0; k < stations.size(); ++k) {
      auto piece = std::find_if(pieces.rbegin(), pieces.rend(),
                                [&](const HeightPiece& p) { return p.s <= stations[k]; });
      ASSERT_NEAR(height_at(*piece, stations[k]), heights[k], 0.01 + 1e-9);
      if (k + 1 == stations.size()) continue;
      // Between two stations the curve stays by their chord.
      const double middle = (stations[k] + stations[k + 1]) / 2;
      ASSERT_NEAR(height_at(*piece, middle), (heights[k] + heights[k + 1]) / 2, 0.05);
    }
  }
  EXPECT_TRUE(height_curve({0}, {1}, 0.01).empty());
}

}  // namespace height_curve_test
}  // namespace streetgen
