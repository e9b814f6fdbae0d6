#include <gtest/gtest.h>

#include <cmath>

#include "geometry/polyline.hpp"
#include "streetgen/object.hpp"

namespace streetgen {
namespace roadway_border_test {

const Line straight{{0, 0, 0}, {100, 0, 0}};

TEST(RoadwayBorder, RunsBesideAStraightAxis) {
  const WidthProfile borders{{{0, 4, 3}, {100, 4, 3}}};
  const Line left = roadway_border(straight, borders, {10, 60, +1, 0.5});
  const Line right = roadway_border(straight, borders, {10, 60, -1, 0.5});
  ASSERT_EQ(left.size(), 2u);
  ASSERT_EQ(right.size(), 2u);
  EXPECT_NEAR(distance(left[0], {10, 4.5}), 0, 1e-9);
  EXPECT_NEAR(distance(left[1], {60, 4.5}), 0, 1e-9);
  EXPECT_NEAR(distance(right[0], {10, -3.5}), 0, 1e-9);
  EXPECT_NEAR(distance(right[1], {60, -3.5}), 0, 1e-9);
}

// From 4 to 8 m over 50 m: each place of the profile is a vertex, the line goes straight between.
TEST(RoadwayBorder, FollowsAWideningStreet) {
  const WidthProfile borders{{{0, 4, 4}, {25, 4, 4}, {75, 8, 4}, {100, 8, 4}}};
  const Line left = roadway_border(straight, borders, {0, 100});
  ASSERT_EQ(left.size(), 4u);
  EXPECT_NEAR(length(left), 50 + std::hypot(50, 4), 1e-9);
  const Line right = roadway_border(straight, borders, {0, 100, -1});
  EXPECT_NEAR(length(right), 100, 1e-9);
}

// Half a circle in 1800 chords, which turn by half a circle less one of the 1800 parts: the border
// at 5 m is shorter on the left, and longer on the right, by the turn times 5 m.
TEST(RoadwayBorder, IsShorterInsideABend) {
  Line bend;
  for (int i = 0; i <= 1800; ++i) {
    const double turn = M_PI * i / 1800;
    bend.push_back({50 * std::sin(turn), 50 - 50 * std::cos(turn), 0});
  }
  const double run = length(bend), turn = M_PI * 1799 / 1800;
  const WidthProfile borders{{{0, 5, 5}, {run, 5, 5}}};
  EXPECT_NEAR(length(roadway_border(bend, borders, {0, run})), run - turn * 5, 1e-4);
  EXPECT_NEAR(length(roadway_border(bend, borders, {0, run, -1})), run + turn * 5, 1e-4);
}

TEST(RoadwayBorder, SaysTheSamePlaceOnce) {
  const WidthProfile repeated{{{0, 4, 4}, {50, 4, 4}, {50 + 8e-15, 4, 4}, {100, 4, 4}}};
  EXPECT_EQ(roadway_border(straight, repeated, {0, 100}).size(), 3u);
  EXPECT_TRUE(roadway_border(straight, repeated, {50, 50}).empty());
}

}  // namespace roadway_border_test
}  // namespace streetgen
