#include "lane/end_control.hpp"

#include <gtest/gtest.h>

namespace streetgen {
namespace end_control_test {

using Direction = ControlPoint::Direction;

// A street of 200 m along x that ends at a node of three edges at each end.
Network street_between_junctions() {
  Network network;
  network.nodes.resize(6);
  const auto edge = [&](std::int64_t axis, int from, int to, Line line) {
    network.nodes[from].point = line.front();
    network.nodes[to].point = line.back();
    network.edges.push_back({axis, from, to, 0, 0, 200, std::move(line)});
  };
  edge(1, 0, 1, {{0, 0}, {200, 0}});
  edge(2, 2, 0, {{0, -200}, {0, 0}});
  edge(3, 0, 3, {{0, 0}, {0, 200}});
  edge(4, 4, 1, {{200, -200}, {200, 0}});
  edge(5, 1, 5, {{200, 0}, {200, 200}});
  return network;
}

std::vector<LanesOfAxis> two_way() {
  std::vector<LanesOfAxis> lanes;
  for (std::int64_t axis = 1; axis <= 5; ++axis)
    lanes.push_back({axis, {{LaneWish{}}, {LaneWish{}}}});
  return lanes;
}

std::vector<EndControl> controlled(const ControlPoint& point) {
  return end_controls(street_between_junctions(), two_way(), {point}, 50);
}

int own_controls(const std::vector<EndControl>& ends) {
  int count = 0;
  for (const EndControl& end : ends) count += end.own ? 1 : 0;
  return count;
}

TEST(EndControl, WithoutPointsNothingIsControlled) {
  EXPECT_EQ(own_controls(end_controls(street_between_junctions(), two_way(), {}, 50)), 0);
}

TEST(EndControl, APointWithoutADirectionSpeaksTowardsTheNearerJunction) {
  const auto near_end = controlled({1, 180, ControlKind::stop, Direction::unknown});
  EXPECT_EQ(near_end[1].own, ControlKind::stop);
  EXPECT_EQ(own_controls(near_end), 1);
  const auto near_start = controlled({1, 20, ControlKind::stop, Direction::unknown});
  EXPECT_EQ(near_start[0].own, ControlKind::stop);
  EXPECT_EQ(own_controls(near_start), 1);
}

TEST(EndControl, WhatComesToARingYields) {
  std::vector<LanesOfAxis> lanes = two_way();
  lanes[1].on_ring = lanes[2].on_ring = true;  // axes 2 and 3, at the start of axis 1
  const Network network = street_between_junctions();
  const auto ends = end_controls(network, lanes, with_ring_entries(network, lanes, {}), 50);
  EXPECT_EQ(ends[0].own, ControlKind::yield);
  EXPECT_EQ(own_controls(ends), 1);
  // A stop sign before it is stricter.
  const ControlPoint sign{1, 10, ControlKind::stop, Direction::against};
  EXPECT_EQ(end_controls(network, lanes, with_ring_entries(network, lanes, {sign}), 50)[0].own,
            ControlKind::stop);
}

TEST(EndControl, ADirectionDecidesAgainstNearness) {
  EXPECT_EQ(own_controls(controlled({1, 20, ControlKind::stop, Direction::along})), 0);
  EXPECT_EQ(controlled({1, 20, ControlKind::stop, Direction::against})[0].own, ControlKind::stop);
}

TEST(EndControl, AOneWayStreetLeavesOneDirection) {
  auto lanes = two_way();
  lanes[0].lanes.backward.clear();
  const std::vector<ControlPoint> point{{1, 20, ControlKind::stop, Direction::unknown}};
  EXPECT_EQ(own_controls(end_controls(street_between_junctions(), lanes, point, 50)), 0);
  EXPECT_EQ(end_controls(street_between_junctions(), lanes, point, 180)[1].own, ControlKind::stop);
}

TEST(EndControl, OnANodeItSpeaksToAllWhoCome) {
  const auto ends = controlled({1, 199, ControlKind::signals, Direction::unknown});
  EXPECT_EQ(own_controls(ends), 3);
  for (const int slot : {1, 7, 8}) EXPECT_EQ(ends[slot].own, ControlKind::signals);
}

TEST(EndControl, OnANodeWithADirectionItSpeaksToOneArm) {
  EXPECT_EQ(own_controls(controlled({1, 199, ControlKind::stop, Direction::along})), 1);
}

TEST(EndControl, SignalsOfOneArmAreSeenByTheOthers) {
  const auto ends = controlled({1, 180, ControlKind::signals, Direction::along});
  for (const int slot : {1, 7, 8}) EXPECT_EQ(ends[slot].at_node, ControlKind::signals);
  EXPECT_EQ(own_controls(ends), 1);
  EXPECT_FALSE(ends[0].at_node);
}

TEST(EndControl, OfSeveralTheStricterHoldsWhateverTheirOrder) {
  const ControlPoint yield{1, 180, ControlKind::yield, Direction::along};
  const ControlPoint stop{1, 190, ControlKind::stop, Direction::along};
  for (const auto& points : {std::vector{yield, stop}, std::vector{stop, yield}})
    EXPECT_EQ(end_controls(street_between_junctions(), two_way(), points, 50)[1].own,
              ControlKind::stop);
}

std::vector<EndControl> decided(const std::vector<JunctionDecision>& decisions) {
  return end_controls(street_between_junctions(), two_way(), {}, 50, decisions);
}

TEST(EndControl, AKindByHandHoldsForTheNearestNodeOfItsAxis) {
  const auto ends = decided({{1, {180, 10}, JunctionKind::signals}});
  for (const int slot : {1, 7, 8}) EXPECT_EQ(ends[slot].decided, JunctionKind::signals);
  for (const int slot : {0, 3, 4, 6, 9}) EXPECT_FALSE(ends[slot].decided);
  EXPECT_EQ(decided({{2, {180, 0}, JunctionKind::signals}})[1].decided, std::nullopt)
      << "farther off than control points";
  EXPECT_EQ(decided({{99, {200, 0}, JunctionKind::signals}})[1].decided, std::nullopt);
}

TEST(EndControl, OfTwoKindsByHandTheLaterHolds) {
  const auto ends =
      decided({{1, {200, 0}, JunctionKind::stop}, {5, {200, 4}, JunctionKind::priority}});
  EXPECT_EQ(ends[7].decided, JunctionKind::priority);
}

TEST(EndControl, OneOnAnAxisThatIsNotThereChangesNothing) {
  EXPECT_EQ(own_controls(controlled({99, 10, ControlKind::stop, Direction::both})), 0);
  EXPECT_EQ(own_controls(controlled({1, 900, ControlKind::stop, Direction::both})), 0);
}

}  // namespace end_control_test
}  // namespace streetgen
