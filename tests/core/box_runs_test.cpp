#include "../../src/core/box_runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace streetgen {
namespace {

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
  const BoxRuns runs(boxes);
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

TEST(Ground, TellsTheBoxOfWhatLiesInABox) {
  const MultiPolygon triangle{{{{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 0, 0}}}};
  const Box held = Ground(triangle).box_within({4, 4, 20, 20});
  EXPECT_NEAR(held.min_x, 4, 1e-5);
  EXPECT_NEAR(held.min_y, 4, 1e-5);
  EXPECT_NEAR(held.max_x, 6, 1e-5);
  EXPECT_NEAR(held.max_y, 6, 1e-5);
  EXPECT_GT(Ground(triangle).box_within({6, 6, 20, 20}).min_x, 6);
}

}  // namespace
}  // namespace streetgen
