#include "interconnection/kerb_clear_path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"

namespace streetgen {
namespace kerb_clear_path_test {

// Streets of 7 m from the node (0, 0) to limits 40 m south and 40 m east of it; the kerb between
// them is a sharp corner at (3.5, -3.5).
const Line south{{0, 0, 0}, {0, -40, 0}}, east{{0, 0, 0}, {40, 0, 0}};
const Point corner{3.5, -3.5, 0};
const MultiPolygon bend{{{{-3.5, -40, 0},
                          {3.5, -40, 0},
                          corner,
                          {40, -3.5, 0},
                          {40, 3.5, 0},
                          {-3.5, 3.5, 0},
                          {-3.5, -40, 0}}}};
const Line southern_border{{-3.5, -40, 0}, {3.5, -40, 0}},
    eastern_border{{40, 3.5, 0}, {40, -3.5, 0}};

Kerbs kerbs() { return Kerbs(bend, {southern_border, eastern_border}); }

TEST(Kerbs, StopAPathThatLeavesTheRoadway) {
  EXPECT_TRUE(kerbs().stop({{1.75, -40, 0}, {40, -1.75, 0}}, 0, 1));
  EXPECT_FALSE(kerbs().stop({{1.75, -40, 0}, {1.75, -1.75, 0}, {40, -1.75, 0}}, 0, 1));
}

TEST(Kerbs, LetAPathThroughTheBorderLinesOfItsTwoStreets) {
  const Line path{{1.75, -41, 0}, {1.75, -1.75, 0}, {41, -1.75, 0}};
  EXPECT_FALSE(kerbs().stop(path, 0, 1));
  EXPECT_TRUE(kerbs().stop(path, 0, 0));
  EXPECT_TRUE(kerbs().stop(path, 1, 1));
}

TEST(Kerbs, StopAPathThatComesNearerThanItsClearance) {
  const Line path{{1.75, -40, 0}, {1.75, -1.75, 0}, {40, -1.75, 0}};
  EXPECT_FALSE(kerbs().stop(path, 0, 1, 1.74));
  EXPECT_TRUE(kerbs().stop(path, 0, 1, 1.76));
}

TEST(LaneToNode, KeepsItsShareOfTheRoadway) {
  // Half of the 6 m beside the axis at its middle: half of 4 m at its start, of 8 m at its end.
  const Line axis{{0, 0, 0}, {100, 0, 0}};
  const Line to_end = lane_to_node(axis, {8, 16}, 50, {50, -3, 0}, false);
  const Line to_start = lane_to_node(axis, {8, 16}, 50, {50, -3, 0}, true);
  EXPECT_NEAR(distance(to_end.back(), {100, -4, 0}), 0, 1e-9);
  EXPECT_NEAR(distance(to_start.back(), {0, -2, 0}), 0, 1e-9);
  for (const Line& line : {to_end, to_start}) EXPECT_EQ(distance(line.front(), {50, -3, 0}), 0);
}

TEST(LaneToNode, KeepsItsShareOfARoadwayBesideTheAxis) {
  // The middle of the roadway lies 2 m to the left: the lane is a metre to its right, of 6 m.
  const Line axis{{0, 0, 0}, {100, 0, 0}};
  const Roadway beside{8, 16, 99, 2};
  const Line to_end = lane_to_node(axis, beside, 50, {50, 1, 0}, false);
  EXPECT_NEAR(distance(to_end.back(), {100, 2 - 8.0 / 6, 0}), 0, 1e-9);
}

TEST(LaneToNode, FollowsTheBendsOfItsAxis) {
  // 2 m right of both pieces: mitred where they meet.
  const Line line =
      lane_to_node({{0, 0, 0}, {50, 0, 0}, {50, -50, 0}}, {7, 7}, 20, {20, -2, 0}, false);
  EXPECT_NEAR(distance_to_line({48, -2, 0}, line), 0, 1e-9);
  EXPECT_NEAR(distance(line.back(), {48, -50, 0}), 0, 1e-9);
}

// A right turn from the southern street to the eastern one on lanes 1.75 m from the kerb.
class Turn : public testing::TestWithParam<TrajectoryRule> {
 protected:
  static LaneToNode lane(const Line& street, const Point& place, const Point& to_node, int border) {
    LaneToNode lane;
    lane.end.place = place;
    lane.end.direction = to_node;
    lane.line = lane_to_node(street, {7, 7}, 40, place, true);
    lane.border = border;
    return lane;
  }
  std::optional<Trajectory> turn(const Kerbs& about) const {
    return late_turn(lane(south, {1.75, -40, 0}, {0, 1, 0}, 0),
                     lane(east, {40, -1.75, 0}, {-1, 0, 0}, 1), GetParam(), 1e-3, about);
  }
};

TEST_P(Turn, PassesTheKerbWithRoomForACarAndNotMuchMore) {
  const auto path = turn(kerbs());
  ASSERT_TRUE(path);
  EXPECT_FALSE(kerbs().stop(path->line, 0, 1));
  // The lanes cross 1.75 times the root of 2 from the corner.
  EXPECT_GE(distance_to_line(corner, path->line), 0.9);
  EXPECT_LE(distance_to_line(corner, path->line), 1.1);
}

TEST_P(Turn, StartsAndEndsOnItsLanesAndFollowsThemOutsideTheCurve) {
  const auto path = turn(kerbs());
  ASSERT_TRUE(path);
  EXPECT_EQ(distance(path->line.front(), {1.75, -40, 0}), 0);
  EXPECT_EQ(distance(path->line.back(), {40, -1.75, 0}), 0);
  EXPECT_NEAR(distance_to_line({1.75, -15, 0}, path->line), 0, 1e-9);
  EXPECT_NEAR(distance_to_line({15, -1.75, 0}, path->line), 0, 1e-9);
}

// With a tolerance of 1 mm no chord of a curve of 3 m and more turns by more than 6 degrees.
TEST_P(Turn, HasNoKink) {
  const auto path = turn(kerbs());
  ASSERT_TRUE(path);
  for (std::size_t i = 2; i < path->line.size(); ++i) {
    const Point before = unit(path->line[i - 1] - path->line[i - 2]);
    const Point after = unit(path->line[i] - path->line[i - 1]);
    EXPECT_LT(std::abs(std::atan2(cross(before, after), dot(before, after))), 0.1);
  }
}

TEST_P(Turn, IsNoneWhereAKerbShutsTheLane) {
  MultiPolygon shut = bend;
  shut.push_back({{{1, -20, 0}, {2, -20, 0}, {2, -19, 0}, {1, -19, 0}, {1, -20, 0}}});
  EXPECT_FALSE(turn(Kerbs(shut, {southern_border, eastern_border})));
}

// Lanes that reach the node, one on the far side of a kerb.
TEST_P(Turn, IsNoneWhereTheLanesEndAtTheNode) {
  MultiPolygon shut = bend;
  shut.push_back({{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}}});
  LaneToNode in, out;
  in.end.place = {0, 0, 0};
  in.end.direction = {0, 1, 0};
  in.line = {in.end.place, in.end.place};
  out.end.place = {3, 0, 0};
  out.end.direction = {-1, 0, 0};
  out.line = {out.end.place, out.end.place};
  EXPECT_FALSE(late_turn(in, out, GetParam(), 1e-3, Kerbs(shut, {})));
}

INSTANTIATE_TEST_SUITE_P(EitherRule, Turn,
                         testing::Values(TrajectoryRule::bezier, TrajectoryRule::arcs));

}  // namespace kerb_clear_path_test
}  // namespace streetgen
