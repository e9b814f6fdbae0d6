#include "streetgen/lane_measures.hpp"

#include <gtest/gtest.h>

#include "geometry/polyline.hpp"

namespace streetgen {
namespace {

const Line bend{{0, 0}, {50, 0}, {50, 50}};
// Offsets of the bend by 3 m: inside on its left, outside with a sharp corner on its right.
const Line inside{{0, 3}, {47, 3}, {47, 50}};
const Line outside{{0, -3}, {53, -3}, {53, 50}};

TEST(LaneMeasures, StraightPiecesAreAsLongOnTheLaneAsOnTheAxis) {
  for (const Line& lane : {inside, outside}) {
    const LaneMeasures places = lane_measures(bend, lane, 5, 0, 100);
    ASSERT_EQ(places.on_axis.size(), 4u);
    // The bend takes 5 m on each side of its vertex, for the widest lane.
    EXPECT_NEAR(places.on_axis[1], 45, 1e-9);
    EXPECT_NEAR(places.on_axis[2], 55, 1e-9);
    EXPECT_NEAR(places.on_lane[1], 45, 1e-9);
    EXPECT_NEAR(places.on_lane[3] - places.on_lane[2], 45, 1e-9);
    EXPECT_NEAR(places.on_lane.back(), length(lane), 1e-9);
  }
}

TEST(LaneMeasures, ThereAndBackIsTheSamePlace) {
  const LaneMeasures in = lane_measures(bend, inside, 5, 0, 100);
  const LaneMeasures out = lane_measures(bend, outside, 5, 0, 100);
  for (double metres = 0; metres <= length(inside); metres += 0.7) {
    const double there =
        measure_at(out.on_axis, out.on_lane, measure_at(in.on_lane, in.on_axis, metres));
    EXPECT_NEAR(measure_at(in.on_axis, in.on_lane, measure_at(out.on_lane, out.on_axis, there)),
                metres, 1e-9);
  }
}

TEST(LaneMeasures, LaneBetweenLimitsThatCoincideKeepsItsLength) {
  const LaneMeasures places = lane_measures(bend, {{20, 3}, {20.01, 3}}, 5, 20, 20);
  ASSERT_EQ(places.on_axis.size(), 2u);
  EXPECT_DOUBLE_EQ(places.on_axis[1] - places.on_axis[0], 1);
  EXPECT_NEAR(places.on_lane[1], 0.01, 1e-12);
}

TEST(LaneMeasures, PlacesOutsideOfTheListAreItsEnds) {
  EXPECT_EQ(measure_at({1, 2}, {10, 20}, 0), 10);
  EXPECT_EQ(measure_at({1, 2}, {10, 20}, 3), 20);
  EXPECT_EQ(measure_at({1, 2}, {10, 20}, 1.5), 15);
}

}  // namespace
}  // namespace streetgen
