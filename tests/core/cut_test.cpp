#include "../../src/core/cut.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "../../src/core/geos.hpp"
#include "../../src/core/polyline.hpp"

namespace streetgen {
namespace {

MultiPolygon rectangle(double x, double y, double width, double height) {
  return {
      {{{x, y, 0}, {x + width, y, 0}, {x + width, y + height, 0}, {x, y + height, 0}, {x, y, 0}}}};
}

// A star-shaped ring about a place.
MultiPolygon star(std::mt19937& random, const Point& centre, int vertices) {
  std::uniform_real_distribution<double> radius(2, 10);
  Ring ring;
  for (int i = 0; i < vertices; ++i) {
    const double turn = 2 * M_PI * i / vertices, r = radius(random);
    ring.push_back(centre + Point{r * std::cos(turn), r * std::sin(turn), 0});
  }
  ring.push_back(ring.front());
  return {{ring}};
}

double rings(const MultiPolygon& surface) {
  double count = 0;
  for (const Polygon& polygon : surface) count += polygon.size();
  return count;
}

TEST(Cut, PartsAreThoseOfAGeneralOverlay) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> away(-12, 12);
  Geos geos;
  for (int turn = 0; turn < 2000; ++turn) {
    const Point centre{650000.123, 6860000.456, 0};
    const MultiPolygon a = star(random, centre, 3 + turn % 40);
    const MultiPolygon b =
        star(random, centre + Point{away(random), away(random), 0}, 3 + turn % 17);
    const auto parts = cut(a, b);
    ASSERT_TRUE(parts) << turn;
    const auto of_a = geos.surface(a), of_b = geos.surface(b);
    const MultiPolygon shared = geos.polygons(geos.intersection(of_a.get(), of_b.get()).get());
    EXPECT_NEAR(area(parts->shared), area(shared), 1e-6) << turn;
    EXPECT_NEAR(area(parts->rest), area(a) - area(shared), 1e-6) << turn;
    EXPECT_EQ(rings(parts->shared), rings(shared)) << turn;
    for (const MultiPolygon* part : {&parts->shared, &parts->rest})
      EXPECT_TRUE(part->empty() || geos.valid(geos.surface(*part).get())) << turn;
    // What was cut off shares its border with the rest: nothing is shared any more, nothing is
    // left.
    const auto again = cut(a, parts->shared);
    ASSERT_TRUE(again) << turn;
    EXPECT_NEAR(area(again->shared), area(parts->shared), 1e-6) << turn;
    EXPECT_NEAR(area(again->rest), area(parts->rest), 1e-6) << turn;
    const auto apart = cut(parts->rest, parts->shared);
    ASSERT_TRUE(apart) << turn;
    EXPECT_NEAR(area(apart->shared), 0, 1e-6) << turn;
  }
}

TEST(Cut, SharedBordersAreNotCrossed) {
  const MultiPolygon a = rectangle(0, 0, 10, 10);
  const auto beside = cut(a, rectangle(10, 2, 5, 5));
  ASSERT_TRUE(beside);
  EXPECT_TRUE(beside->shared.empty());
  EXPECT_DOUBLE_EQ(area(beside->rest), 100);
  const auto same = cut(a, a);
  ASSERT_TRUE(same);
  EXPECT_DOUBLE_EQ(area(same->shared), 100);
  EXPECT_TRUE(same->rest.empty());
  // A border made in two ways, apart by less than can be told.
  const auto corner = cut(a, rectangle(5, -3e-8, 5 + 3e-8, 5));
  ASSERT_TRUE(corner);
  EXPECT_NEAR(area(corner->shared), 25, 1e-6);
  EXPECT_EQ(rings(corner->rest), 1);
}

TEST(Cut, HolesAndPartsComeOut) {
  const MultiPolygon a = rectangle(0, 0, 10, 10);
  const auto hole = cut(a, rectangle(4, 4, 2, 2));
  ASSERT_TRUE(hole);
  ASSERT_EQ(hole->rest.size(), 1u);
  EXPECT_EQ(hole->rest.front().size(), 2u);
  EXPECT_DOUBLE_EQ(area(hole->rest), 96);
  const auto bar = cut(a, rectangle(-1, 4, 12, 2));
  ASSERT_TRUE(bar);
  EXPECT_EQ(bar->rest.size(), 2u);
  // A hole that touches the shell in one point stays a ring of its own.
  const MultiPolygon diamond{{{{5, 0, 0}, {7, 3, 0}, {5, 6, 0}, {3, 3, 0}, {5, 0, 0}}}};
  const auto touching = cut(a, diamond);
  ASSERT_TRUE(touching);
  ASSERT_EQ(touching->rest.size(), 1u);
  EXPECT_EQ(touching->rest.front().size(), 2u);
  Geos geos;
  EXPECT_TRUE(geos.valid(geos.surface(touching->rest).get()));
  const auto through = cut(hole->rest, rectangle(4, -1, 2, 12));
  ASSERT_TRUE(through);
  EXPECT_DOUBLE_EQ(area(through->shared), 16);
  EXPECT_EQ(through->shared.size(), 2u);
}

TEST(Cut, FarApartNothingIsShared) {
  const auto parts = cut(rectangle(0, 0, 1, 1), rectangle(5, 5, 1, 1));
  ASSERT_TRUE(parts);
  EXPECT_TRUE(parts->shared.empty());
  EXPECT_DOUBLE_EQ(area(parts->rest), 1);
  const auto empty = cut({}, rectangle(0, 0, 1, 1));
  ASSERT_TRUE(empty);
  EXPECT_TRUE(empty->shared.empty() && empty->rest.empty());
}

}  // namespace
}  // namespace streetgen
