#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "geometry/polyline.hpp"
#include "streetgen/junction.hpp"

namespace streetgen {
namespace group_junctions_test {

JunctionEdge edge_of(const JunctionNetwork& network, int from, int to, bool along = true,
                     bool against = true, std::int64_t name = 0) {
  JunctionEdge edge;
  edge.axis_id = static_cast<std::int64_t>(network.edges.size()) + 1;
  edge.from_node = from;
  edge.to_node = to;
  edge.line = {network.nodes[from], network.nodes[to]};
  edge.along = along;
  edge.against = against;
  edge.name = name;
  return edge;
}

void add(JunctionNetwork& network, int from, int to, bool along = true, bool against = true,
         std::int64_t name = 0) {
  network.edges.push_back(edge_of(network, from, to, along, against, name));
}

// A two-way street that crosses two carriageways `apart` metres from each other, nodes 0 and 1.
JunctionNetwork dual_carriageway(double apart) {
  JunctionNetwork network;
  network.nodes = {{0, 0},        {0, apart},   {-100, 0}, {100, 0},
                   {-100, apart}, {100, apart}, {0, -100}, {0, apart + 100}};
  add(network, 0, 1);
  add(network, 2, 0, true, false);
  add(network, 0, 3, true, false);
  add(network, 5, 1, true, false);
  add(network, 1, 4, true, false);
  add(network, 6, 0);
  add(network, 1, 7);
  return network;
}

TEST(GroupJunctions, CarriagewaysNearEachOtherAreOneJunction) {
  const JunctionGroups groups = group_junctions(dual_carriageway(20), {});
  EXPECT_EQ(groups.of_node[0], groups.of_node[1]);
  EXPECT_EQ(groups.roles[0], EdgeRole::inside);
  EXPECT_EQ(std::count(groups.roles.begin(), groups.roles.end(), EdgeRole::outside), 6);
}

TEST(GroupJunctions, BeyondTheGapTheyAreTwo) {
  const JunctionGroups groups = group_junctions(dual_carriageway(36), {});
  EXPECT_NE(groups.of_node[0], groups.of_node[1]);
  EXPECT_FALSE(groups.parted[0]);
}

TEST(GroupJunctions, StreetsOfTwoNamesAreNoCarriageways) {
  JunctionNetwork network = dual_carriageway(20);
  network.edges[1].name = network.edges[2].name = 7;
  EXPECT_EQ(group_junctions(network, {}).of_node[0], group_junctions(network, {}).of_node[1]);
  network.edges[3].name = network.edges[4].name = 8;
  EXPECT_NE(group_junctions(network, {}).of_node[0], group_junctions(network, {}).of_node[1]);
  network.edges[3].name = network.edges[4].name = 7;
  EXPECT_EQ(group_junctions(network, {}).of_node[0], group_junctions(network, {}).of_node[1]);
}

// Streets that are one-way in turn cross each other every 28 m.
TEST(GroupJunctions, AGridOfOneWayStreetsHasNoCarriageways) {
  for (const bool named : {false, true}) {
    constexpr int streets = 5;
    JunctionNetwork network;
    for (int row = 0; row < streets; ++row)
      for (int column = 0; column < streets; ++column)
        network.nodes.push_back({28.0 * column, 28.0 * row});
    for (int row = 0; row < streets; ++row)
      for (int i = 0; i + 1 < streets; ++i) {
        const bool along = row % 2 == 0;
        add(network, streets * row + i, streets * row + i + 1, along, !along, named ? 1 + row : 0);
        add(network, streets * i + row, streets * (i + 1) + row, along, !along,
            named ? 101 + row : 0);
      }
    const JunctionGroups groups = group_junctions(network, {});
    for (int node = 0; node < streets * streets; ++node) EXPECT_EQ(groups.of_node[node], node);
  }
}

TEST(GroupJunctions, ALinkInSeveralEdgesIsOne) {
  JunctionNetwork network = dual_carriageway(20);
  network.nodes.push_back({0, 9});
  network.edges[0].to_node = 8;
  network.edges[0].line = {network.nodes[0], network.nodes[8]};
  add(network, 8, 1);
  const JunctionGroups groups = group_junctions(network, {});
  EXPECT_EQ(groups.of_node[0], groups.of_node[1]);
  EXPECT_EQ(groups.of_node[0], groups.of_node[8]);
  EXPECT_EQ(groups.roles[0], EdgeRole::inside);
  EXPECT_EQ(groups.roles[7], EdgeRole::inside);
  network.edges[7].by_hand = false;
  const JunctionGroups parted = group_junctions(network, {});
  EXPECT_NE(parted.of_node[0], parted.of_node[1]);
}

TEST(GroupJunctions, TwoWayStreetsAreNoCarriageways) {
  JunctionNetwork network = dual_carriageway(20);
  for (JunctionEdge& edge : network.edges) edge.against = true;
  const JunctionGroups groups = group_junctions(network, {});
  EXPECT_NE(groups.of_node[0], groups.of_node[1]);
}

TEST(GroupJunctions, OneWayStreetsOfOneDirectionAreNoCarriageways) {
  JunctionNetwork network = dual_carriageway(20);
  std::swap(network.edges[3].along, network.edges[3].against);
  std::swap(network.edges[4].along, network.edges[4].against);
  EXPECT_NE(group_junctions(network, {}).of_node[0], group_junctions(network, {}).of_node[1]);
}

TEST(GroupJunctions, CarriagewaysThatEndAtTheLinkNeedOneName) {
  JunctionNetwork network = dual_carriageway(20);
  network.edges.erase(network.edges.begin() + 4);
  network.edges.erase(network.edges.begin() + 2);
  // Degree three stays, with a street to either side.
  add(network, 0, 3);
  add(network, 1, 5);
  EXPECT_NE(group_junctions(network, {}).of_node[0], group_junctions(network, {}).of_node[1]);
  network.edges[1].name = network.edges[2].name = 7;
  EXPECT_EQ(group_junctions(network, {}).of_node[0], group_junctions(network, {}).of_node[1]);
}

TEST(GroupJunctions, CrossedLimitsJoinHoweverWide) {
  JunctionNetwork network;
  for (int i = 0; i < 5; ++i) network.nodes.push_back({60.0 * i, 0});
  for (int i = 0; i < 4; ++i) {
    add(network, i, i + 1);
    network.edges.back().crossed = true;
  }
  const JunctionGroups groups = group_junctions(network, {});
  EXPECT_EQ(std::count(groups.of_node.begin(), groups.of_node.end(), 0), 5);
  EXPECT_EQ(std::count(groups.roles.begin(), groups.roles.end(), EdgeRole::inside), 4);
}

TEST(GroupJunctions, TheExtentPartsAndSaysSo) {
  const JunctionGroups groups = group_junctions(dual_carriageway(20), {35, 10, 50});
  EXPECT_NE(groups.of_node[0], groups.of_node[1]);
  EXPECT_TRUE(groups.parted[0]);
  EXPECT_EQ(groups.chain_of_node[0], groups.chain_of_node[1]);
}

TEST(GroupJunctions, HandsDecide) {
  JunctionNetwork network = dual_carriageway(20);
  network.edges[0].by_hand = false;
  EXPECT_NE(group_junctions(network, {}).of_node[0], group_junctions(network, {}).of_node[1]);
  network.edges[0].by_hand.reset();
  network.edges[6].by_hand = true;
  EXPECT_EQ(group_junctions(network, {}).of_node[7], group_junctions(network, {}).of_node[1]);
}

TEST(GroupJunctions, WhatHandsJoinTakesNoExtentFromTheRules) {
  JunctionNetwork network = dual_carriageway(20);
  network.edges[6].by_hand = true;
  const JunctionGroups groups = group_junctions(network, {});
  EXPECT_EQ(groups.of_node[0], groups.of_node[1]);
  EXPECT_EQ(groups.of_node[1], groups.of_node[7]);
  EXPECT_FALSE(groups.parted[0]);
}

TEST(GroupJunctions, RoundaboutsStayApart) {
  JunctionNetwork network = dual_carriageway(20);
  network.edges[0].on_ring = true;
  EXPECT_NE(group_junctions(network, {}).of_node[0], group_junctions(network, {}).of_node[1]);
}

TEST(GroupJunctions, ASlipLaneBelongsToItsCorner) {
  JunctionNetwork network;
  network.nodes = {{0, 0}, {-40, 0}, {0, -40}, {-100, 0}, {0, -100}, {100, 0}, {0, 100}};
  add(network, 3, 1);
  add(network, 1, 0);
  add(network, 0, 2);
  add(network, 2, 4);
  add(network, 0, 5);
  add(network, 0, 6);
  JunctionEdge slip = edge_of(network, 1, 2, true, false);
  slip.line = {{-40, 0}, {-25, -5}, {-5, -25}, {0, -40}};
  network.edges.push_back(slip);
  const JunctionGroups groups = group_junctions(network, {});
  EXPECT_EQ(groups.roles[6], EdgeRole::slip_lane);
  EXPECT_EQ(groups.roles[1], EdgeRole::inside);
  EXPECT_EQ(groups.roles[2], EdgeRole::inside);
  for (const int node : {1, 2}) EXPECT_EQ(groups.of_node[node], 0);
  network.edges[6].against = true;
  EXPECT_EQ(group_junctions(network, {}).roles[6], EdgeRole::outside);
}

// Which edges lie in one junction does not depend on the order of nodes and edges.
// Streets cross a road at nodes 0 and 1, so many metres apart, where signals stand.
JunctionNetwork two_signals(double apart) {
  JunctionNetwork network;
  network.nodes = {{0, 0},    {apart, 0}, {-100, 0},     {apart + 100, 0},
                   {0, -100}, {0, 100},   {apart, -100}, {apart, 100}};
  for (const auto& [from, to] : {std::pair(0, 1), {2, 0}, {1, 3}, {4, 0}, {0, 5}, {6, 1}, {1, 7}})
    add(network, from, to);
  for (JunctionEdge& edge : network.edges)
    edge.end_abscissa = distance(edge.line.front(), edge.line.back());
  network.controls = {{2, 100, ControlKind::signals}, {3, 0, ControlKind::signals}};
  return network;
}

TEST(GroupJunctions, SignalsWithoutRoomForAQueueBetweenThemAreOneJunction) {
  const JunctionGroups groups = group_junctions(two_signals(24), {});
  EXPECT_EQ(groups.of_node[0], groups.of_node[1]);
  EXPECT_EQ(groups.roles[0], EdgeRole::inside);
  EXPECT_EQ(groups.served, (std::vector<int>{0, 1}));
  const JunctionGroups apart = group_junctions(two_signals(26), {});
  EXPECT_NE(apart.of_node[0], apart.of_node[1]);
  JunctionNetwork one = two_signals(24);
  one.controls.pop_back();
  EXPECT_NE(group_junctions(one, {}).of_node[0], group_junctions(one, {}).of_node[1]);
}

TEST(GroupJunctions, OrderDecidesNothing) {
  std::mt19937 random(7);
  for (int round = 0; round < 100; ++round) {
    JunctionNetwork network;
    std::uniform_real_distribution<double> place(0, 150);
    for (int n = 0; n < 14; ++n) network.nodes.push_back({place(random), place(random)});
    for (int e = 0; e < 26; ++e) {
      const int from = static_cast<int>(random() % 14), to = static_cast<int>(random() % 14);
      if (from == to) continue;
      const int way = static_cast<int>(random() % 3);
      add(network, from, to, way != 1, way != 2, random() % 3);
      network.edges.back().crossed = random() % 8 == 0;
    }
    JunctionNetwork shuffled = network;
    std::shuffle(shuffled.edges.begin(), shuffled.edges.end(), random);
    const JunctionGroups a = group_junctions(network, {}), b = group_junctions(shuffled, {});
    for (std::size_t e = 0; e < network.edges.size(); ++e)
      for (std::size_t s = 0; s < shuffled.edges.size(); ++s)
        if (shuffled.edges[s].axis_id == network.edges[e].axis_id) {
          EXPECT_EQ(a.roles[e], b.roles[s]) << round;
          EXPECT_EQ(a.parted[e], b.parted[s]) << round;
        }
    EXPECT_EQ(a.of_node, b.of_node) << round;
    // An edge lies in one junction or leads from one to another.
    for (std::size_t e = 0; e < network.edges.size(); ++e) {
      if (a.roles[e] == EdgeRole::outside) continue;
      EXPECT_EQ(a.of_node[network.edges[e].from_node], a.of_node[network.edges[e].to_node]);
    }
  }
}

}  // namespace group_junctions_test
}  // namespace streetgen
