#include "geometry/box_hierarchy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"

namespace streetgen {
namespace box_hierarchy_test {

// A row of boxes that wanders, as the sides of a ring do.
std::vector<Box> row(int count, std::mt19937& random) {
  std::uniform_real_distribution<double> step(-2, 3);
  std::vector<Box> boxes;
  Point at{};
  for (int i = 0; i < count; ++i) {
    const Point next{at.x + step(random), at.y + step(random), 0};
    boxes.push_back(box_of(at, next));
    at = next;
  }
  return boxes;
}

class Runs : public testing::TestWithParam<int> {};

TEST_P(Runs, FindWhatOneByOneIsFound) {
  std::mt19937 random(GetParam());
  const std::vector<Box> boxes = row(GetParam(), random);
  const BoxHierarchy runs(boxes);
  std::uniform_real_distribution<double> place(-10, 10 + GetParam() / 2.0);
  for (int i = 0; i < 100; ++i) {
    const Point p{place(random), place(random), 0}, q{p.x + 5, p.y + 2, 0};
    std::vector<std::size_t> found, expected;
    EXPECT_FALSE(runs.any_near(box_of(p, q), 1, [&](std::size_t k) {
      found.push_back(k);
      return false;
    }));
    int nearest = -1;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      if (box_of(p, q).grown(1).meets(boxes[k], 0)) expected.push_back(k);
      if (boxes[k].square_from(p) >= least) continue;
      least = boxes[k].square_from(p);
      nearest = static_cast<int>(k);
    }
    EXPECT_EQ(found, expected);
    EXPECT_EQ(runs.nearest(p, [&](int k) { return boxes[k].square_from(p); }), nearest);
  }
}

INSTANTIATE_TEST_SUITE_P(OfSizes, Runs, testing::Values(0, 1, 7, 8, 9, 64, 65, 500, 513));

TEST(PreparedSurface, TellsTheBoxOfWhatLiesInABox) {
  const MultiPolygon triangle{{{{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 0, 0}}}};
  const Box held = PreparedSurface(triangle).box_within({4, 4, 20, 20});
  EXPECT_NEAR(held.min_x, 4, 1e-5);
  EXPECT_NEAR(held.min_y, 4, 1e-5);
  EXPECT_NEAR(held.max_x, 6, 1e-5);
  EXPECT_NEAR(held.max_y, 6, 1e-5);
  EXPECT_GT(PreparedSurface(triangle).box_within({6, 6, 20, 20}).min_x, 6);
}

// A wavy ring about the centre, of so many sides, that goes round once or back.
Ring wavy(std::mt19937& random, const Point& centre, double radius, int sides, double way) {
  std::uniform_real_distribution<double> share(0.5, 1);
  Ring ring;
  for (int i = 0; i < sides; ++i) {
    const double angle = way * 2 * M_PI * i / sides, away = radius * share(random);
    ring.push_back(centre + Point{away * std::cos(angle), away * std::sin(angle), 0});
  }
  ring.push_back(ring.front());
  return ring;
}

// Runs of sides are told by their ends, those of several rings one by one.
TEST(PreparedSurface, HoldsAPlaceThatLiesInsideItsRings) {
  std::mt19937 random(7);
  for (const int sides : {3, 8, 9, 64, 65, 700}) {
    const MultiPolygon surface{
        {wavy(random, {0, 0, 0}, 20, sides, 1), wavy(random, {1, 1, 0}, 8, sides, -1)},
        {wavy(random, {50, 3, 0}, 20, sides, 1)}};
    const PreparedSurface ground(surface);
    std::uniform_real_distribution<double> x(-21, 71), y(-21, 24);
    int held = 0;
    for (int i = 0; i < 2000; ++i) {
      const Point place{x(random), y(random), 0};
      held += inside(place, surface);
      EXPECT_EQ(ground.holds(place), inside(place, surface)) << sides << " sides, place " << i;
    }
    EXPECT_GT(held, 100);
  }
}

}  // namespace box_hierarchy_test
}  // namespace streetgen
