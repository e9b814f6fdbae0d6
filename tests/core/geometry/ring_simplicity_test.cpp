#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/geos.hpp"
#include "geometry/polyline.hpp"
#include "geometry/ring_simplicity.hpp"

namespace streetgen {
namespace ring_simplicity_test {

Ring ring(std::vector<std::pair<double, double>> corners) {
  Ring out;
  for (const auto& [x, y] : corners) out.push_back({650000 + x, 6860000 + y, 0});
  out.push_back(out.front());
  return out;
}

TEST(Simple, KnowsRingsThatKeepApartAndRingsThatCross) {
  EXPECT_EQ(simple({{ring({{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}})}}), true);
  EXPECT_EQ(simple({{ring({{0, 0}, {4, 4}, {4, 0}, {0, 4}})}}), false);
  EXPECT_EQ(
      simple({{ring({{0, 0}, {9, 0}, {9, 9}, {0, 9}}), ring({{2, 2}, {2, 4}, {4, 4}, {4, 2}})}}),
      true);
  EXPECT_EQ(
      simple({{ring({{0, 0}, {3, 0}, {3, 3}, {0, 3}})}, {ring({{2, 2}, {5, 2}, {5, 5}, {2, 5}})}}),
      false);
}

TEST(Simple, LeavesTouchesUndecided) {
  EXPECT_EQ(simple({{ring({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}})}}), std::nullopt);
  EXPECT_EQ(simple({{ring({{0, 0}, {4, 0}, {4, 4}, {6, 4}, {4, 4}, {0, 4}})}}), std::nullopt);
  EXPECT_EQ(simple({{ring({{0, 0}, {4, 0}, {4, 4}, {2, 1e-8}, {0, 4}})}}), std::nullopt);
}

TEST(Simple, KnowsTheShortestSideOfAWayThatGoesOn) {
  EXPECT_EQ(simple({{ring({{0, 0}, {4, 0}, {4, 2}, {4, 2 + 5e-8}, {4, 4}, {0, 4}})}}), true);
  EXPECT_EQ(simple({{ring({{0, 0}, {4, 0}, {4 + 4e-8, 4e-8}, {6, 4}, {0, 4}})}}), true);
  // From a side that goes back nearly along the first.
  EXPECT_EQ(simple({{ring({{0, 0}, {4, 0}, {4, 5e-8}, {1, 1e-8}, {0, 4}})}}), std::nullopt);
}

TEST(Simple, AgreesWithGeos) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> off(0.2, 1), place(0, 1);
  Geos geos;
  int known = 0, crossed = 0;
  for (int round = 0; round < 500; ++round) {
    std::vector<std::pair<double, double>> corners;
    for (int i = 0; i < 12; ++i) {
      const double turn = i + (round % 2 == 0 ? 0 : 3 * place(random)), reach = 10 * off(random);
      corners.emplace_back(reach * std::cos(turn * M_PI / 6), reach * std::sin(turn * M_PI / 6));
    }
    const MultiPolygon surface{{ring(corners)}};
    const auto answer = simple(surface);
    if (!answer) continue;
    ++known;
    crossed += !*answer;
    EXPECT_EQ(*answer, geos.valid(geos.surface(surface).get())) << round;
  }
  EXPECT_GT(known, 450);
  EXPECT_GT(crossed, 100);
  EXPECT_LT(crossed, 400);
}

}  // namespace ring_simplicity_test
}  // namespace streetgen
