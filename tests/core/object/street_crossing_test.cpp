#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/polyline.hpp"
#include "streetgen/object.hpp"

namespace streetgen {
namespace street_crossing_test {

const Line straight{{0, 0, 0}, {100, 0, 0}};

WidthProfile even(double left, double right) { return {{{0, left, right}, {100, left, right}}}; }

double ground_area(const Line& axis, const WidthProfile& borders, const StreetCrossing& crossing) {
  const auto ground = crossing_ground(axis, borders, crossing);
  return ground ? area({*ground}) : 0;
}

TEST(StreetCrossing, TakesItsWidthFromBorderToBorder) {
  EXPECT_NEAR(ground_area(straight, even(4, 4), {50, 4, M_PI / 2}), 4 * 8, 1e-9);
  EXPECT_NEAR(ground_area(straight, even(6, 1), {50, 3, M_PI / 2}), 3 * 7, 1e-9);
}

// A parallelogram between borders `width` apart: its base along the kerb is width / sin(angle).
TEST(StreetCrossing, IsLongerWhereItGoesAslant) {
  for (const double degrees : {45.0, 60.0, 120.0})
    EXPECT_NEAR(ground_area(straight, even(4, 4), {50, 4, degrees * M_PI / 180}),
                8 * 4 / std::sin(degrees * M_PI / 180), 1e-9);
}

TEST(StreetCrossing, GoesStraightOnBeyondTheEndsOfItsAxis) {
  for (const double at : {0.0, 1.0, 100.0})
    EXPECT_NEAR(ground_area(straight, even(4, 4), {at, 4, M_PI / 2}), 4 * 8, 1e-9);
}

// 8 m wide on the whole at 25 m, 12 m at 75 m: as a trapezium about 50 m has its mean width.
TEST(StreetCrossing, FollowsBordersThatChange) {
  const WidthProfile widening{{{0, 3, 3}, {25, 4, 4}, {75, 4, 8}, {100, 4, 8}}};
  EXPECT_NEAR(ground_area(straight, widening, {50, 4, M_PI / 2}), 4 * 10, 1e-9);
}

TEST(StreetCrossing, SeesNoDifferenceInRepeatedPlaces) {
  const WidthProfile repeated{{{0, 4, 4}, {50, 4, 4}, {50 + 8e-15, 4, 4}, {100, 4, 4}}};
  const Line line{{0, 0, 0}, {0, 0, 0}, {50, 0, 0}, {50 + 1e-9, 0, 0}, {100, 0, 0}};
  EXPECT_NEAR(ground_area(line, repeated, {50, 4, M_PI / 2}), 4 * 8, 1e-6);
  EXPECT_EQ(crossing_stripes(line, repeated, {50, 4, M_PI / 2}).size(), 7u);
}

// Half a metre of each metre, a quarter of a metre free on either side.
TEST(StreetCrossing, HasAStripeForEachMetre) {
  for (const double half : {0.3, 0.5, 1.4, 1.6, 4.0, 7.0}) {
    const MultiPolygon stripes = crossing_stripes(straight, even(half, half), {50, 4, M_PI / 2});
    const double count = half < 0.5 ? 0 : 2 * std::floor(half - 0.5) + 1;
    EXPECT_EQ(static_cast<double>(stripes.size()), count) << half;
    EXPECT_NEAR(area(stripes), count * 0.5 * 4, 1e-9) << half;
  }
}

// Of a street of 8 m: 7 stripes of 0.5 m on 4 m; lines of 0.2 m on the 7.5 m between borders that
// are left free.
TEST(StreetCrossing, IsPaintedByItsMarking) {
  const auto painted = [](CrossingPaint paint) {
    return crossing_stripes(straight, even(4, 4), {50, 4, M_PI / 2}, paint);
  };
  const double stripes = 7 * 0.5 * 4, lines = 2 * 0.2 * 7.5, ends = 7 * 0.5 * 2 * 0.2;
  EXPECT_NEAR(area(painted(CrossingPaint::zebra)), stripes, 1e-9);
  EXPECT_NEAR(area(painted(CrossingPaint::lines)), lines, 1e-9);
  EXPECT_NEAR(area(painted(CrossingPaint::ladder)), stripes + lines - ends, 1e-6);
  EXPECT_NEAR(area(painted(CrossingPaint::dashes)), ends, 1e-9);
  EXPECT_NEAR(area(painted(CrossingPaint::dots)), 14 * 0.3 * 0.3, 1e-9);
  EXPECT_EQ(painted(CrossingPaint::lines).size(), 2u);
  EXPECT_EQ(painted(CrossingPaint::ladder).size(), 1u);
  EXPECT_EQ(painted(CrossingPaint::dashes).size(), 14u);
  EXPECT_EQ(painted(CrossingPaint::dots).size(), 14u);
}

TEST(StreetCrossing, PaintsNothingWhereThereIsNoRoom) {
  for (const CrossingPaint paint :
       {CrossingPaint::zebra, CrossingPaint::ladder, CrossingPaint::lines, CrossingPaint::dashes,
        CrossingPaint::dots})
    EXPECT_TRUE(crossing_stripes(straight, even(0.2, 0.2), {50, 4, M_PI / 2}, paint).empty());
}

// Also where it goes aslant: from one line to the other it is as deep as stripes are.
TEST(StreetCrossing, HasItsLinesAtTheEndsOfItsStripes) {
  const StreetCrossing crossing{50, 4, M_PI / 3};
  for (const Polygon& line : crossing_stripes(straight, even(4, 4), crossing, CrossingPaint::lines))
    for (const Point& point : line[0]) {
      const double along = std::abs(point.x - 50 - point.y / std::tan(crossing.angle));
      EXPECT_LE(along, 2 + 1e-9);
      EXPECT_GE(along, 1.8 - 1e-9);
      EXPECT_NEAR(std::abs(point.y), 3.75, 1e-9);
    }
}

TEST(StreetCrossing, PaintsFromTheMiddleOfTheRoadway) {
  const MultiPolygon stripes = crossing_stripes(straight, even(5, -2), {50, 4, M_PI / 2});
  ASSERT_EQ(stripes.size(), 3u);
  for (const Polygon& stripe : stripes)
    for (const Point& point : stripe[0]) EXPECT_LE(std::abs(point.y - 3.5), 1.25 + 1e-9);
}

// Paint lies within the ground, also where it goes aslant.
TEST(StreetCrossing, PaintsWithinItsGround) {
  for (const double degrees : {45.0, 90.0, 135.0}) {
    const StreetCrossing crossing{50, 4, degrees * M_PI / 180};
    for (const Polygon& stripe : crossing_stripes(straight, even(4, 4), crossing))
      for (const Point& point : stripe[0]) {
        EXPECT_LE(std::abs(point.y), 3.75 + 1e-9);
        const double along = point.x - 50 - point.y / std::tan(crossing.angle);
        EXPECT_LE(std::abs(along), 2 + 1e-9);
      }
  }
}

// No stripe turns over where the axis bends, and none lies on another one.
TEST(StreetCrossing, PaintsNoMetreTwiceInABend) {
  std::mt19937_64 random(22);
  std::uniform_real_distribution<double> step(-12, 12), at(0, 40), slant(0.6, 2.5);
  for (int n = 0; n < 300; ++n) {
    Line axis{{0, 0, 0}};
    while (axis.size() < 6) axis.push_back(axis.back() + Point{8, step(random), 0});
    const StreetCrossing crossing{at(random), 4, slant(random)};
    double sum = 0;
    for (const Polygon& stripe : crossing_stripes(axis, even(5, 5), crossing)) {
      EXPECT_GT(signed_area(stripe[0]), 0) << n;
      sum += area({stripe});
    }
    EXPECT_LE(sum, area(crossing_stripes(straight, even(5, 5), crossing)) * 1.5) << n;
  }
}

TEST(StreetCrossing, HasNoGroundWithoutAnAxis) {
  const Line nowhere{{3, 4, 0}, {3, 4, 0}};
  EXPECT_FALSE(crossing_ground(nowhere, even(4, 4), {0, 4, M_PI / 2}));
  EXPECT_TRUE(crossing_stripes(nowhere, even(4, 4), {0, 4, M_PI / 2}).empty());
}

}  // namespace street_crossing_test
}  // namespace streetgen
