// Roads of a network: what holds of every chain, and the examples of Algorithm 2.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "geometry/polyline.hpp"
#include "streetgen/arc_road.hpp"
#include "streetgen/road.hpp"

namespace streetgen {
namespace roads_test {

constexpr double shift = 0.5;

// Random axes between few places, so that they meet, ring and double each other.
Network random_network(unsigned seed) {
  std::mt19937_64 random(seed);
  const auto pick = [&](int n) { return static_cast<int>(random() % n); };
  std::vector<NetworkAxis> axes;
  const int count = 5 + pick(20);
  for (int id = 1; id <= count; ++id) {
    const Point from{650000 + 80.0 * pick(5), 6860000 + 80.0 * pick(5), 0};
    const Point to{650000 + 80.0 * pick(5), 6860000 + 80.0 * pick(5), 0};
    const Point bend = (from + to) * 0.5 + Point{5.0 + pick(20), -3.0 - pick(20), 0};
    axes.push_back({id, pick(2) ? Line{from, bend, to} : Line{to, bend, from}, 0});
  }
  return network(axes, 0.5, Crossing::over);
}

Network of_axes(const std::vector<NetworkAxis>& axes) { return network(axes, 0.5, Crossing::over); }

std::vector<int> degrees(const Network& network) {
  std::vector<int> degree(network.nodes.size());
  for (const Edge& edge : network.edges) {
    ++degree[edge.from_node];
    ++degree[edge.to_node];
  }
  return degree;
}

int first_node(const Network& network, const RoadMember& member) {
  const Edge& edge = network.edges[member.edge];
  return member.along ? edge.from_node : edge.to_node;
}

int last_node(const Network& network, const RoadMember& member) {
  const Edge& edge = network.edges[member.edge];
  return member.along ? edge.to_node : edge.from_node;
}

TEST(Roads, EveryEdgeIsInOneAndCountsAreThoseOfTheNetwork) {
  for (unsigned seed = 1; seed <= 300; ++seed) {
    const Network town = random_network(seed);
    const std::vector<int> degree = degrees(town);
    const std::vector<Road> found = roads(town, {}, shift, {});
    std::set<int> seen;
    std::size_t closed = 0;
    double length = 0, of_edges = 0;
    for (const Road& road : found) {
      closed += road.closed;
      length += road.length;
      for (const RoadMember& member : road.members) EXPECT_TRUE(seen.insert(member.edge).second);
    }
    for (const Edge& edge : town.edges) of_edges += edge.end_abscissa - edge.start_abscissa;
    const auto of_two = static_cast<std::size_t>(std::count(degree.begin(), degree.end(), 2));
    EXPECT_EQ(seen.size(), town.edges.size());
    EXPECT_EQ(found.size(), town.edges.size() - of_two + closed) << "seed " << seed;
    EXPECT_NEAR(length, of_edges, 1e-9 * of_edges);
  }
}

TEST(Roads, GoThroughNodesOfTwoAndEndAtOthers) {
  for (unsigned seed = 1; seed <= 300; ++seed) {
    const Network town = random_network(seed);
    const std::vector<int> degree = degrees(town);
    for (const Road& road : roads(town, {}, shift, {})) {
      EXPECT_EQ(first_node(town, road.members.front()), road.from_node);
      EXPECT_EQ(last_node(town, road.members.back()), road.to_node);
      for (std::size_t i = 1; i < road.members.size(); ++i) {
        EXPECT_EQ(first_node(town, road.members[i]), last_node(town, road.members[i - 1]));
        EXPECT_EQ(degree[first_node(town, road.members[i])], 2);
      }
      EXPECT_EQ(road.closed, road.from_node == road.to_node && degree[road.from_node] == 2);
      if (!road.closed) {
        EXPECT_NE(degree[road.from_node], 2);
        EXPECT_NE(degree[road.to_node], 2);
      }
    }
  }
}

TEST(Roads, RunAlongTheirSmallestEdge) {
  for (unsigned seed = 1; seed <= 100; ++seed) {
    const Network town = random_network(seed);
    for (const Road& road : roads(town, {}, shift, {})) {
      const auto least =
          std::min_element(road.members.begin(), road.members.end(),
                           [](const auto& a, const auto& b) { return a.edge < b.edge; });
      EXPECT_TRUE(least->along);
      if (road.closed) {
        EXPECT_EQ(least, road.members.begin());
      }
    }
  }
}

// All four cases of join: end to start, start to start, end to end, start to end.
TEST(Roads, JoinEdgesHoweverTheyAreDrawn) {
  const Point a{0, 0, 0}, b{100, 0, 0}, c{200, 10, 0};
  for (const Line& first : {Line{a, b}, Line{b, a}})
    for (const Line& second : {Line{b, c}, Line{c, b}}) {
      const Network town = of_axes({{1, first, 0}, {2, second, 0}});
      const std::vector<Road> found = roads(town, {}, shift, {});
      ASSERT_EQ(found.size(), 1u);
      EXPECT_EQ(found[0].members.size(), 2u);
      EXPECT_NEAR(found[0].length, 100 + std::hypot(100, 10), 1e-9);
    }
}

TEST(Roads, AreCurvesWithoutAGap) {
  for (unsigned seed = 1; seed <= 100; ++seed) {
    const Network town = random_network(seed);
    for (const Road& road : roads(town, {}, shift, {})) {
      EXPECT_TRUE(same(road.curve.front().arc.start, planar(town.nodes[road.from_node].point)));
      EXPECT_TRUE(same(road.curve.back().arc.end, planar(town.nodes[road.to_node].point)));
      for (std::size_t i = 1; i < road.curve.size(); ++i)
        EXPECT_EQ(distance(road.curve[i - 1].arc.end, road.curve[i].arc.start), 0);
    }
  }
}

TEST(Roads, HaveOneTangentWhereTwoEdgesGoOn) {
  const Network town = of_axes({{1, {{0, 0, 0}, {60, 0, 0}, {100, 30, 0}}, 0},
                                {2, {{200, 70, 0}, {140, 70, 0}, {100, 30, 0}}, 0}});
  const std::vector<Road> found = roads(town, {}, shift, {});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(ArcRoad::along(found[0].curve).kinks().empty());
  EXPECT_EQ(ArcRoad::along(found[0].curve).bends().size(), 4u);
}

TEST(Roads, EndWhereOtherEdgesAreSaidToMeet) {
  const Network town =
      of_axes({{1, {{0, 0, 0}, {100, 0, 0}}, 0}, {2, {{100, 0, 0}, {200, 10, 0}}, 0}});
  std::vector<bool> branching(town.nodes.size());
  branching[town.edges[0].to_node] = true;
  EXPECT_EQ(roads(town, {}, shift, {}).size(), 1u);
  EXPECT_EQ(roads(town, branching, shift, {}).size(), 2u);
}

// A corner of a right angle after 100 m.
ArcRoad::Bend bend_of(double wanted, double abscissa = 100) {
  const Network town = of_axes({{1, {{0, 0, 0}, {100, 0, 0}, {100, 50, 0}}, 0}});
  const auto bends =
      ArcRoad::along(roads(town, {}, shift, {{1, abscissa, wanted}})[0].curve).bends();
  return bends.empty() ? ArcRoad::Bend{} : bends[0];
}

TEST(RoadOverride, GivesABendItsRadius) {
  EXPECT_NEAR(bend_of(20).stretch.radius, 20, 1e-9);
  EXPECT_NEAR(bend_of(20, 100.9).stretch.radius, 20, 1e-9);
}

TEST(RoadOverride, ChangesNothingAwayFromItsBend) {
  EXPECT_NEAR(bend_of(20, 98).stretch.radius, bend_of(20, 300).stretch.radius, 1e-9);
}

// A right angle takes its radius of both segments: 50 m are there.
TEST(RoadOverride, ThatDoesNotFitBecomesTheGreatestThatDoes) {
  EXPECT_NEAR(bend_of(80).stretch.radius, 50, 1e-6);
}

TEST(RoadOverride, MakesABendSharp) { EXPECT_EQ(bend_of(0).stretch.radius, 0); }

TEST(RoadOverride, OfZeroOrMoreAlwaysFits) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<> size(0, 400), place(-60, 60);
  for (int run = 0; run < 500; ++run) {
    Line line{{0, 0, 0}};
    for (int i = 1; i < 8; ++i)
      line.push_back(line.back() + Point{place(random), place(random), 0});
    const Network town = of_axes({{1, line, 0}});
    std::vector<RoadOverride> wishes;
    double abscissa = 0;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      abscissa += distance(line[i - 1], line[i]);
      wishes.push_back({1, abscissa, size(random)});
    }
    EXPECT_NO_THROW(roads(town, {}, shift, wishes));
  }
}

// A wish of one bend leaves its neighbours an arc: the road keeps one tangent everywhere.
TEST(RoadOverride, TakesNoArcFromOtherBends) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<> size(1, 400), place(-60, 60);
  for (int run = 0; run < 500; ++run) {
    Line line{{0, 0, 0}};
    for (int i = 1; i < 8; ++i)
      line.push_back(line.back() + Point{place(random), place(random), 0});
    std::vector<RoadOverride> wishes;
    double abscissa = 0;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      abscissa += distance(line[i - 1], line[i]);
      if (random() % 2 == 0) wishes.push_back({1, abscissa, size(random)});
    }
    // A line that meets itself is cut into several edges, whose ends are no bends.
    for (const Road& road : roads(of_axes({{1, line, 0}}), {}, shift, wishes))
      if (road.members.size() == 1) EXPECT_TRUE(ArcRoad::along(road.curve).kinks().empty());
  }
}

}  // namespace roads_test
}  // namespace streetgen
