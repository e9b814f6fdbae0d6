// Two edges that go on nearly straight share one border line, and nothing lies between them.
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/polyline.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {
namespace straight_junction_test {

// Two streets 7 m wide; the second one turns by so many thousandths of a radian.
Streets turned(double thousandths, const StreetOverrides& overrides = {}) {
  const double turn = thousandths * 1e-3;
  return streets(
      {{1, {{0, 0, 0}, {100, 0, 0}}, 0, 7, 7, 6, 3},
       {2, {{100, 0, 0}, {100 + 80 * std::cos(turn), 80 * std::sin(turn), 0}}, 0, 7, 7, 6, 3}},
      {}, overrides);
}

TEST(StraightJunction, HasNoIntersection) {
  // The bend covers 3.5^2 m2 a radian.
  for (const double turn : {0.0, 0.01, 0.8, -0.8}) {
    const Streets town = turned(turn);
    ASSERT_EQ(town.intersections.size(), 1U);
    EXPECT_TRUE(town.intersections[0].surface.empty()) << turn;
    EXPECT_EQ(town.limits[1].abscissa, length(town.network.edges[0].line));
    EXPECT_EQ(town.limits[2].abscissa, 0);
    EXPECT_TRUE(same(town.limits[1].border_line, town.limits[2].border_line)) << turn;
    EXPECT_NEAR(distance(town.limits[1].border_line[0], town.limits[1].border_line[1]), 7, 1e-9);
    // What is left out is what the sections give to each other.
    EXPECT_NEAR(area(town.sections[0].surface) + area(town.sections[1].surface), 7 * 180,
                3.5 * 3.5 * std::abs(turn) * 1e-3 + 1e-9);
    EXPECT_EQ(town.sections[0].method, Method::hypothesis);
  }
}

// Rounding once left a street that a junction takes up whole a limit of a femtometre at its end.
TEST(StraightJunction, SharesItsBorderLineWithAJunctionThatTakesUpAStreet) {
  for (int i = 0; i < 50; ++i) {
    const double size = 6.2 + i * 0.0113;
    const Streets town = streets({{1, {{-60, 0, 0}, {0, 0, 0}}, 0, 12, 12, 6, 3},
                                  {2, {{0, 0, 0}, {60, 0, 0}}, 0, 12, 12, 6, 3},
                                  {3, {{0, 0, 0}, {0, size, 0}}, 0, 4, 4, 6, 3},
                                  {4, {{0, size, 0}, {0.002, size + 80, 0}}, 0, 4, 4, 6, 3}},
                                 {}, {});
    EXPECT_EQ(town.limits[5].abscissa, size);
    EXPECT_TRUE(same(town.limits[5].border_line, town.limits[6].border_line)) << size;
  }
}

TEST(StraightJunction, HasOneWhereItBendsMore) {
  const Streets town = turned(1);
  EXPECT_GT(area(town.intersections[0].surface), 0.01);
}

TEST(StraightJunction, IsPartedByALimitByHand) {
  const Streets town = turned(0.5, {{{1, 90, false}}, {}});
  EXPECT_EQ(town.limits[1].abscissa, 90);
  EXPECT_NEAR(area(town.intersections[0].surface), 7 * 10, 0.01);
}

}  // namespace straight_junction_test
}  // namespace streetgen
