#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/geos.hpp"
#include "geometry/polyline.hpp"
#include "streetgen/surface.hpp"

namespace streetgen {
namespace crossing_surface_test {

CurvedLine curve(const Line& line) {
  CurvedLine out;
  for (std::size_t i = 1; i < line.size(); ++i) out.push_back({{line[i - 1], {}, line[i]}, false});
  return out;
}

Point turned(const Point& p, double angle, const Point& shift) {
  return Point{p.x * std::cos(angle) - p.y * std::sin(angle),
               p.x * std::sin(angle) + p.y * std::cos(angle), 0} +
         shift;
}

Line turned(Line line, double angle, const Point& shift) {
  for (Point& p : line) p = turned(p, angle, shift);
  return line;
}

const Line axis{{0, 0, 0}, {100, 0, 0}};
const Line left{{0, 4, 0}, {100, 4, 0}};
const Line right{{0, -3, 0}, {100, -3, 0}};

TEST(CrossingSurface, OfAStraightStreetIsAParallelogram) {
  for (const double degrees : {20.0, 45.0, 90.0, 120.0, 160.0}) {
    const double angle = degrees * M_PI / 180;
    const auto surface = crossing_surface(axis, curve(left), curve(right), 50, 3, angle);
    ASSERT_TRUE(surface);
    EXPECT_NEAR(area({*surface}), 3 * 7 / std::sin(angle), 1e-9) << degrees;
  }
}

// At 45 degrees the way across leads ahead on the left.
TEST(CrossingSurface, LeansAsTheAngleSays) {
  const auto surface = crossing_surface(axis, curve(left), curve(right), 50, 2, M_PI / 4);
  ASSERT_TRUE(surface);
  double before = 1e9, after = -1e9;
  for (const Point& p : surface->front()) {
    if (p.y > 0) before = std::min(before, p.x);
    if (p.y > 0) after = std::max(after, p.x);
  }
  EXPECT_NEAR(before, 54 - std::sqrt(2), 1e-9);
  EXPECT_NEAR(after, 54 + std::sqrt(2), 1e-9);
}

TEST(CrossingSurface, IsTheSameTurnedAndMirrored) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < 50; ++i) {
    Line bent = left;
    bent.insert(bent.begin() + 1, {40 + 20 * share(random), 4 + 2 * share(random), 0});
    const double angle = 0.6 + 1.9 * share(random), at = 20 + 60 * share(random);
    const auto surface = crossing_surface(axis, curve(bent), curve(right), at, 4, angle);
    ASSERT_TRUE(surface);
    const double turn = 6 * share(random);
    const Point shift{650000, 6860000, 0};
    const auto there = crossing_surface(turned(axis, turn, shift), curve(turned(bent, turn, shift)),
                                        curve(turned(right, turn, shift)), at, 4, angle);
    ASSERT_TRUE(there);
    EXPECT_NEAR(area({*there}), area({*surface}), 1e-6);
    const auto backwards =
        crossing_surface(reversed(axis), curve(right), curve(bent), 100 - at, 4, angle);
    ASSERT_TRUE(backwards);
    EXPECT_NEAR(area({*backwards}), area({*surface}), 1e-9);
  }
}

// Between the borders at x = 48 and 52 the kerb is the circle of radius 10 about (50, 14).
TEST(CrossingSurface, FollowsACurvedKerb) {
  const CurvedLine bay{{{{40, 14, 0}, {50, 4, 0}, {60, 14, 0}}, true}};
  const auto surface = crossing_surface(axis, bay, curve(right), 50, 4, M_PI / 2);
  ASSERT_TRUE(surface);
  const double half = std::asin(0.2), under = 14 * 4 - (2 * std::sqrt(96.0) + 100 * half);
  EXPECT_NEAR(area({*surface}), 4 * 3 + under, 4 * 1e-3);
}

TEST(CrossingSurface, FollowsANotchInTheKerb) {
  const Line notched{{0, 4, 0}, {49, 4, 0}, {49, 6, 0}, {51, 6, 0}, {51, 4, 0}, {100, 4, 0}};
  const auto surface = crossing_surface(axis, curve(notched), curve(right), 50, 4, M_PI / 2);
  ASSERT_TRUE(surface);
  EXPECT_NEAR(area({*surface}), 4 * 7 + 2 * 2, 1e-9);
}

// The rear kerb of the closed one would be the longer way about.
TEST(CrossingSurface, FollowsAClosedKerbTheShorterWay) {
  const Line island{{48.5, 4, 0}, {80, 4, 0}, {80, 9, 0}, {20, 9, 0}, {20, 4, 0}, {48.5, 4, 0}};
  const auto surface = crossing_surface(axis, curve(island), curve(right), 49, 3, M_PI / 2);
  ASSERT_TRUE(surface);
  EXPECT_NEAR(area({*surface}), 3 * 7, 1e-9);
}

TEST(CrossingSurface, IsCutStraightWhereTheKerbRunsAway) {
  const Line hairpin{{0, 4, 0}, {50, 4, 0}, {90, 5, 0}, {50, 6, 0}, {51, 7, 0}, {100, 30, 0}};
  const Line far{{0, 4, 0}, {50, 4, 0}, {0, 30, 0}, {100, 30, 0}};
  for (const Line& kerb : {hairpin, far}) {
    const auto surface = crossing_surface(axis, curve(kerb), curve(right), 50, 4, M_PI / 2);
    ASSERT_TRUE(surface);
    Geos geos;
    EXPECT_TRUE(geos.valid({*surface}));
    for (const Point& p : surface->front()) EXPECT_NEAR(p.x, 50, 4);
  }
}

TEST(CrossingSurface, IsNoneWithoutAKerbWithinTenWidths) {
  const Line far{{0, 31, 0}, {100, 31, 0}};
  EXPECT_FALSE(crossing_surface(axis, curve(far), curve(right), 50, 3, M_PI / 2));
  EXPECT_TRUE(crossing_surface(axis, curve(far), curve(right), 50, 4, M_PI / 2));
  EXPECT_FALSE(
      crossing_surface(axis, curve({{0, 4, 0}, {49, 4, 0}}), curve(right), 50, 3, M_PI / 2));
}

}  // namespace crossing_surface_test
}  // namespace streetgen
