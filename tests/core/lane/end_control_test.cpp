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

std::vector<ControlEdge> two_way(const Network& network) {
  std::vector<ControlEdge> edges;
  for (const Edge& edge : network.edges)
    edges.push_back(control_edge({true, true}, 4, 7, 7, edge.line));
  return edges;
}

EndControls controls_in(const Network& network, const std::vector<ControlPoint>& points,
                        double farthest = 50) {
  return end_controls(network, two_way(network), points, {farthest, 25});
}

std::vector<EndControl> controlled(const ControlPoint& point) {
  return controls_in(street_between_junctions(), {point}).ends;
}

int own_controls(const std::vector<EndControl>& ends) {
  int count = 0;
  for (const EndControl& end : ends) count += end.own ? 1 : 0;
  return count;
}

TEST(EndControl, WithoutPointsNothingIsControlled) {
  EXPECT_EQ(own_controls(controls_in(street_between_junctions(), {}).ends), 0);
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
  std::vector<LanesOfAxis> lanes;
  for (std::int64_t axis = 1; axis <= 5; ++axis) lanes.push_back({axis, {}});
  lanes[1].on_ring = lanes[2].on_ring = true;  // axes 2 and 3, at the start of axis 1
  const Network network = street_between_junctions();
  const auto ends = controls_in(network, with_ring_entries(network, lanes, {})).ends;
  EXPECT_EQ(ends[0].own, ControlKind::yield);
  EXPECT_EQ(own_controls(ends), 1);
  // A stop sign before it is stricter.
  const ControlPoint sign{1, 10, ControlKind::stop, Direction::against};
  EXPECT_EQ(controls_in(network, with_ring_entries(network, lanes, {sign})).ends[0].own,
            ControlKind::stop);
}

TEST(EndControl, ADirectionDecidesAgainstNearness) {
  EXPECT_EQ(own_controls(controlled({1, 20, ControlKind::stop, Direction::along})), 0);
  EXPECT_EQ(controlled({1, 20, ControlKind::stop, Direction::against})[0].own, ControlKind::stop);
}

TEST(EndControl, AOneWayStreetLeavesOneDirection) {
  const Network network = street_between_junctions();
  auto edges = two_way(network);
  edges[0].ways.against = false;
  const std::vector<ControlPoint> point{{1, 20, ControlKind::stop, Direction::unknown}};
  EXPECT_EQ(own_controls(end_controls(network, edges, point, {50, 25}).ends), 0);
  EXPECT_EQ(end_controls(network, edges, point, {180, 25}).ends[1].own, ControlKind::stop);
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
    EXPECT_EQ(controls_in(street_between_junctions(), points).ends[1].own, ControlKind::stop);
}

std::vector<EndControl> decided(const std::vector<JunctionDecision>& decisions) {
  const Network network = street_between_junctions();
  return end_controls(network, two_way(network), {}, {50, 25}, decisions).ends;
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

// The street between junctions in two pieces, which meet at a node of two edges at 170 m.
Network street_in_pieces() {
  Network network = street_between_junctions();
  network.nodes.push_back({{170, 0}, {{6, 0}}});
  Edge piece = network.edges[0];
  piece.axis_id = 6;
  piece.from_node = 6;
  piece.start_abscissa = 0;
  piece.end_abscissa = 30;
  piece.line = {{170, 0}, {200, 0}};
  network.edges[0].to_node = 6;
  network.edges[0].end_abscissa = 170;
  network.edges[0].line = {{0, 0}, {170, 0}};
  network.edges.push_back(piece);
  return network;
}

TEST(EndControl, APointReachesTheJunctionOverANodeOfTwoEdges) {
  for (const double abscissa : {155.0, 170.0}) {
    const auto found = controls_in(street_in_pieces(), {{1, abscissa, ControlKind::stop}});
    EXPECT_EQ(found.ends[11].own, ControlKind::stop) << abscissa;
    EXPECT_EQ(own_controls(found.ends), 1) << abscissa;
    EXPECT_EQ(found.served, std::vector<int>{1}) << abscissa;
  }
}

TEST(EndControl, SignalsWithoutAJunctionAheadBelongToTheOneWithinAQueueBehind) {
  const auto near =
      controls_in(street_between_junctions(), {{1, 20, ControlKind::signals, Direction::along}});
  EXPECT_EQ(near.ends[0].own, ControlKind::signals);
  EXPECT_EQ(near.ends[4].at_node, ControlKind::signals);
  const auto stop =
      controls_in(street_between_junctions(), {{1, 20, ControlKind::stop, Direction::along}});
  EXPECT_EQ(own_controls(stop.ends), 0);
  EXPECT_EQ(stop.served, std::vector<int>{-1});
}

TEST(EndControl, SignalsInMidBlockSpeakAtTheNodeThatTheyStandOn) {
  Network network = street_between_junctions();
  network.nodes.push_back({{100, 0}, {{1, 100}}});
  Edge second = network.edges[0];
  second.from_node = network.edges[0].to_node = 6;
  network.edges[0].end_abscissa = second.start_abscissa = 100;
  network.edges[0].line = {{0, 0}, {100, 0}};
  second.line = {{100, 0}, {200, 0}};
  network.edges.insert(network.edges.begin() + 1, second);
  const auto found = controls_in(network, {{1, 95, ControlKind::signals, Direction::along},
                                           {1, 105, ControlKind::signals, Direction::against}});
  EXPECT_EQ(found.ends[1].own, ControlKind::signals);
  EXPECT_EQ(found.ends[2].own, ControlKind::signals);
  EXPECT_EQ(own_controls(found.ends), 2);
  EXPECT_EQ(found.served, (std::vector<int>{6, 6}));
}

TEST(EndControl, SignalsInMidBlockWithoutANodeOfTheirOwnSpeakAtTheJunction) {
  const auto found =
      controls_in(street_between_junctions(),
                  {{1, 160, ControlKind::signals}, {1, 160, ControlKind::pedestrian_crossing}});
  EXPECT_EQ(found.ends[1].own, ControlKind::signals);
  EXPECT_EQ(found.served, (std::vector<int>{1, 1}));
}

// A street of importance 3 crosses one of importance 4 at the node of two more edges.
TEST(EndControl, ASignOnAJunctionBindsTheMinorArmsUnlessItSpeaksToBothDirections) {
  const Network network = street_between_junctions();
  auto edges = two_way(network);
  edges[1].importance = edges[2].importance = 3;
  const auto bound = [&](ControlKind kind, Direction direction) {
    return own_controls(end_controls(network, edges, {{1, 0, kind, direction}}, {50, 25}).ends);
  };
  EXPECT_EQ(bound(ControlKind::stop, Direction::unknown), 1);
  EXPECT_EQ(bound(ControlKind::yield, Direction::unknown), 1);
  EXPECT_EQ(bound(ControlKind::stop, Direction::both), 3);
  EXPECT_EQ(bound(ControlKind::signals, Direction::unknown), 3);
}

TEST(EndControl, OfEqualArmsTheStraighterPairGoesFirstWhereStreetsAreImportant) {
  const Network network = street_between_junctions();
  auto edges = two_way(network);
  EXPECT_FALSE(end_controls(network, edges, {}, {50, 25}).ends[0].waits);
  for (ControlEdge& edge : edges) edge.importance = 3;
  const auto ends = end_controls(network, edges, {}, {50, 25}).ends;
  EXPECT_TRUE(ends[0].waits);
  EXPECT_FALSE(ends[3].waits || ends[4].waits);
  // Nobody comes but by the stem.
  edges[1].ways = {false, true}, edges[2].ways = {true, false};
  EXPECT_FALSE(end_controls(network, edges, {}, {50, 25}).ends[0].waits);
}

}  // namespace end_control_test
}  // namespace streetgen
