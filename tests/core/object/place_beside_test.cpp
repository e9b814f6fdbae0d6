#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/polyline.hpp"
#include "streetgen/object.hpp"

namespace streetgen {
namespace place_beside_test {

const Line bent{{0, 0, 0}, {100, 0, 0}, {100, 50, 0}};

void expect_point(const StandingPlace& place, double x, double y, double degrees) {
  EXPECT_NEAR(place.point.x, x, 1e-9);
  EXPECT_NEAR(place.point.y, y, 1e-9);
  EXPECT_NEAR(place.direction * 180 / M_PI, degrees, 1e-9);
}

TEST(PlaceBeside, LiesOnTheNormal) {
  expect_point(place_beside(bent, {30, 5}), 30, 5, 90);
  expect_point(place_beside(bent, {30, -5}), 30, -5, 90);
  expect_point(place_beside(bent, {120, 5}), 95, 20, 0);
}

TEST(PlaceBeside, HalvesTheAngleAtAVertex) {
  const double aside = 5 * std::sqrt(0.5);
  expect_point(place_beside(bent, {100, -5}), 100 + aside, -aside, 45);
}

TEST(PlaceBeside, IsClampedToTheAxis) {
  expect_point(place_beside(bent, {-3, 2}), 0, 2, 90);
  expect_point(place_beside(bent, {500, 2}), 98, 50, 0);
}

TEST(BesideAxis, TellsBeyondAnEndHowFar) {
  const PlaceBeside found = beside_axis(bent, {-3, 4, 0});
  EXPECT_EQ(found.abscissa, 0);
  EXPECT_NEAR(found.offset, 5, 1e-12);
  EXPECT_NEAR(beside_axis(bent, {-3, -4, 0}).offset, -5, 1e-12);
}

TEST(BesideAxis, KnowsTheSideAtAVertex) {
  EXPECT_NEAR(beside_axis(bent, {104, -3, 0}).offset, -5, 1e-12);
  EXPECT_NEAR(beside_axis(bent, {104, -3, 0}).abscissa, 100, 1e-12);
}

TEST(BesideAxis, SeesNoDifferenceInRepeatedPoints) {
  const Line repeated{{0, 0, 0}, {0, 0, 0}, {100, 0, 0}, {100, 0, 0}};
  const PlaceBeside found = beside_axis(repeated, {40, -7, 0});
  EXPECT_NEAR(found.abscissa, 40, 1e-12);
  EXPECT_NEAR(found.offset, -7, 1e-12);
  expect_point(place_beside(repeated, found), 40, -7, 90);
}

// There and back, for places whose nearest place of the axis is no vertex.
TEST(BesideAxis, IsTheInverse) {
  std::mt19937_64 random(28);
  std::uniform_real_distribution<double> step(-60, 60), beside(-40, 40);
  int tried = 0;
  for (std::size_t n = 0; n < 10000; ++n) {
    Line axis{{6e5 + step(random), 6.8e6 + step(random), 0}};
    while (axis.size() < 2 + n % 9)
      axis.push_back(axis.back() + Point{step(random), step(random), 0});
    const Point place = axis[n % axis.size()] + Point{beside(random), beside(random), 0};
    const PlaceBeside found = beside_axis(axis, place);
    EXPECT_NEAR(std::abs(found.offset), distance_to_line(place, axis), 1e-6) << n;
    double at = 0, nearest = found.abscissa;
    for (std::size_t i = 1; i < axis.size(); ++i) {
      at += distance(axis[i - 1], axis[i]);
      nearest = std::min(nearest, std::abs(found.abscissa - at));
    }
    if (nearest < 1e-6) continue;
    ++tried;
    EXPECT_LT(distance(place_beside(axis, found).point, place), 1e-6) << n;
  }
  EXPECT_GT(tried, 3000);
}

}  // namespace place_beside_test
}  // namespace streetgen
