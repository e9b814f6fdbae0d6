#include "streetgen/traffic_network.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "streetgen/error.hpp"

namespace streetgen {
namespace {

// A street to the east and one to the north, each of one lane, with a turn between them.
TrafficSource corner() {
  TrafficSource source;
  source.edges = {{{{0, 0, 10}, {50, 0, 12}}, true, 2}, {{{60, 10, 12.5}, {60, 60, 15}}, true, 2}};
  TrafficLink east;
  east.link_id = 5;
  east.line = {{0, 0}, {50, 0}};
  east.width = 3.5;
  east.speed = 14;
  east.edge = 0;
  east.last = 50;
  east.stop = 2;
  east.from_node = 1;
  east.to_node = east.junction = 2;
  TrafficLink north = east;
  north.link_id = 9;
  north.line = {{60, 10}, {60, 60}};
  north.edge = 1;
  north.from_node = 2;
  north.to_node = 3;
  north.junction = 0;
  TrafficLink turn;
  turn.link_id = 6;
  turn.movement = true;
  for (int i = 0; i <= 20; ++i) {
    const double at = M_PI / 2 * i / 20;
    turn.line.push_back({50 + 10 * std::sin(at), 10 - 10 * std::cos(at)});
  }
  turn.width = 3.5;
  turn.lane_in = 5;
  turn.lane_out = 9;
  turn.junction = 2;
  source.links = {north, turn, east};
  return source;
}

struct Ends {
  LinkFrame from, to;
};
Ends ends_of(const TrafficNetwork& network, int link) {
  return {frame(network, {link, 0}), frame(network, {link, network.links[link].length})};
}

void expect_smooth(const TrafficNetwork& network) {
  for (int i = 0; i < network.size(); ++i)
    for (const int next : network.next.of(i)) {
      const LinkFrame end = ends_of(network, i).to, start = ends_of(network, next).from;
      EXPECT_NEAR(end.x, start.x, 1e-6);
      EXPECT_NEAR(end.y, start.y, 1e-6);
      EXPECT_NEAR(std::remainder(end.heading - start.heading, 2 * M_PI), 0, 1e-6);
    }
}

TEST(TrafficNetwork, LinksComeByTheirKeysAndLeadFromLaneToLane) {
  const TrafficNetwork network = traffic_network(corner());
  ASSERT_EQ(network.size(), 3);
  EXPECT_EQ(link_of(network, 6), 1);
  ASSERT_EQ(network.next.of(0).size(), 1);
  EXPECT_EQ(network.next.of(0)[0], 1);
  EXPECT_EQ(network.next.of(1)[0], 2);
  EXPECT_EQ(network.before.of(2)[0], 1);
  EXPECT_EQ(network.links[0].straight_on, 1);
  EXPECT_EQ(network.links[2].straight_on, -1);
  EXPECT_FLOAT_EQ(network.links[0].stop, 48);
}

TEST(TrafficNetwork, TurnIsAnArcThatNobodyTakesFasterThanItsRadiusAllows) {
  const TrafficNetwork network = traffic_network(corner());
  expect_smooth(network);
  const LinkFrame middle = frame(network, {1, network.links[1].length / 2});
  EXPECT_NEAR(1 / middle.curvature, 10, 0.2);
  EXPECT_NEAR(middle.heading, M_PI / 4, 1e-2);
  EXPECT_NEAR(network.links[1].speed, std::sqrt(0.7 * 9.81 / middle.curvature), 1e-3);
}

// A kink between lanes that touch turns by next to nothing, on a micrometre.
TEST(TrafficNetwork, NobodyBrakesWhereLanesTouch) {
  for (const double turn : {1e-9, 1e-6, 1e-4}) {
    TrafficSource source = corner();
    source.links[0].line = {{50, 0}, {50 + 40 * std::cos(turn), 40 * std::sin(turn)}};
    source.edges[1].line = {{50, 0, 12}, {50 + 40 * std::cos(turn), 40 * std::sin(turn), 12}};
    source.links[1].line = {{50, 0}, {50 + 1e-7 * std::cos(0.8), 1e-7 * std::sin(0.8)}};
    EXPECT_FLOAT_EQ(traffic_network(source).links[1].speed, 14) << turn;
  }
}

TEST(TrafficNetwork, LanesThatTouchBendTowardsEachOther) {
  TrafficSource source = corner();
  source.links[0].line = {{50, 0}, {50 + 40 * std::cos(0.3), 40 * std::sin(0.3)}};
  source.links[1].line = {{50, 0}, {50, 0}};
  const TrafficNetwork network = traffic_network(source);
  expect_smooth(network);
  EXPECT_NEAR(ends_of(network, 0).to.heading, 0.15, 1e-9);
  EXPECT_LT(network.links[1].length, 1e-6);
}

TEST(TrafficNetwork, HeightsFollowTheEdgeAndClimbEvenlyBetweenLanes) {
  const TrafficNetwork network = traffic_network(corner());
  EXPECT_NEAR(frame(network, {0, 25}).height, 11, 1e-5);
  EXPECT_NEAR(frame(network, {0, 25}).grade, 0.04, 1e-6);
  EXPECT_NEAR(frame(network, {1, network.links[1].length / 2}).height, 12.25, 1e-5);
  TrafficSource flat = corner();
  flat.edges[0].has_heights = flat.edges[1].has_heights = false;
  EXPECT_TRUE(traffic_network(flat).heights.rows.empty());
}

TEST(TrafficNetwork, LaneAgainstTheAxisSeesItsNeighbourTheOtherWayRound) {
  TrafficSource source = corner();
  TrafficLink back = source.links[2];
  back.link_id = 12;
  back.line = {{50, 3.5}, {0, 3.5}};
  back.along = false;
  source.links.push_back(back);
  source.beside = {{5, 12, true, false, true, 0, 50}, {12, 5, true, false, true, 0, 50}};
  const TrafficNetwork network = traffic_network(source);
  const auto there = beside(network, {link_of(network, 5), 10}, true);
  EXPECT_EQ(network.links[there.place.link].link_id, 12);
  EXPECT_NEAR(there.place.metres, 40, 1e-5);
  EXPECT_TRUE(there.opposite);
  EXPECT_NEAR(beside(network, there.place, true).place.metres, 10, 1e-5);
  EXPECT_EQ(beside(network, {link_of(network, 5), 10}, false).place.link, -1);
}

// Two pairs of movements that merge, one at each of two junctions.
TEST(TrafficNetwork, MovementsOfAJunctionConflictWhateverTheirKeys) {
  TrafficSource source;
  const auto street = [&](std::int64_t key, const Line& line, std::int64_t from, std::int64_t to) {
    TrafficLink lane;
    lane.link_id = key;
    lane.line = line;
    lane.width = 3.5;
    lane.speed = 14;
    lane.edge = static_cast<int>(source.edges.size());
    lane.last = 40;
    lane.from_node = from;
    lane.to_node = to;
    source.edges.push_back({line, false, 2});
    source.links.push_back(lane);
  };
  const auto movement = [&](std::int64_t key, const Line& line, std::int64_t in, std::int64_t out,
                            std::int64_t junction) {
    TrafficLink link;
    link.link_id = key;
    link.movement = true;
    link.line = line;
    link.width = 3.5;
    link.lane_in = in;
    link.lane_out = out;
    link.junction = junction;
    source.links.push_back(link);
  };
  for (const int j : {0, 1}) {
    const double x = 1000 * j;
    const std::int64_t k = 100 * j;
    street(k + 1, {{x - 60, 0}, {x - 20, 0}}, 0, 7 + j);
    street(k + 5, {{x - 60, 40}, {x - 20, 15}}, 0, 7 + j);
    street(k + 9, {{x + 20, 0}, {x + 60, 0}}, 7 + j, 0);
    // The second movement of each junction has a key beyond the first one of the other.
    movement(1002 + 4 * j, {{x - 20, 0}, {x + 20, 0}}, k + 1, k + 9, 7 + j);
    movement(2002 + 4 * j, {{x - 20, 15}, {x, 3}, {x + 20, 0}}, k + 5, k + 9, 7 + j);
  }
  const TrafficNetwork network = traffic_network(source);
  for (const std::int64_t key : {1002, 1006, 2002, 2006}) {
    const auto conflicts = network.conflicts.of(link_of(network, key));
    ASSERT_EQ(conflicts.size(), 1) << key;
    EXPECT_EQ(network.links[conflicts[0].link].link_id % 1000, key % 1000);
  }
  EXPECT_NO_THROW(require_sound(network));
}

std::string refusal(const TrafficSource& source) {
  try {
    traffic_network(source);
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

TEST(TrafficNetwork, BadSourcesAreRefusedAndMovementsOfNoLaneLeftOut) {
  TrafficSource source = corner();
  source.links.push_back(source.links[0]);
  EXPECT_EQ(refusal(source), "link 9 stands more than once in the list");
  source = corner();
  source.links[0].line = {{1, 1}, {1, 1}};
  EXPECT_EQ(refusal(source), "link 9 has no length");
  source = corner();
  source.links[0].edge = 2;
  EXPECT_EQ(refusal(source), "link 9 has no edge");
  source = corner();
  source.beside = {{5, 7, true, false, false, 0, 1}};
  EXPECT_EQ(refusal(source), "link 7 lies beside another one, and is no lane");
  source = corner();
  source.links.erase(source.links.begin());
  EXPECT_EQ(traffic_network(source).size(), 1);
}

}  // namespace
}  // namespace streetgen
