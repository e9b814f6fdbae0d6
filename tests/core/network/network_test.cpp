#include "streetgen/network.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "geometry/polyline.hpp"

namespace streetgen {
namespace network_test {

NetworkAxis axis(std::int64_t id, Line line, int level = 0) { return {id, std::move(line), level}; }

int degree(const Network& network, const Point& at) {
  int count = 0;
  for (const Edge& edge : network.edges) {
    count += distance(network.nodes[edge.from_node].point, at) < 1;
    count += distance(network.nodes[edge.to_node].point, at) < 1;
  }
  return count;
}

TEST(Network, CutsAxesAtASharedVertex) {
  const Network n = network({axis(1, {{0, 0}, {50, 0}, {100, 0}}), axis(2, {{50, 0}, {50, 60}})},
                            0.5, Crossing::over);
  EXPECT_EQ(n.edges.size(), 3u);
  EXPECT_EQ(degree(n, {50, 0}), 3);
}

TEST(Network, IsNotSeveredWhereTwoEndsMeetASegmentFaceToFace) {
  const Network n = network({axis(1, {{0, 0}, {100, 0}}), axis(2, {{50, 0.4}, {50, 60}}),
                             axis(3, {{50, -0.4}, {50, -60}})},
                            0.5, Crossing::over);
  EXPECT_EQ(n.edges.size(), 4u);
  EXPECT_EQ(n.nodes.size(), 5u);
  EXPECT_EQ(degree(n, {50, 0}), 4);
}

TEST(Network, JoinsUndershootsAndOvershootsInTheMiddleOfASegment) {
  for (const double y : {0.4, -0.4, 0.0}) {
    const Network n =
        network({axis(1, {{0, 0}, {100, 0}}), axis(2, {{50, y}, {50, 60}})}, 0.5, Crossing::over);
    EXPECT_EQ(n.edges.size(), 3u) << y;
    EXPECT_EQ(degree(n, {50, 0}), 3) << y;
  }
}

// Two ends in one place have as many arms as a vertex inside an axis, and count as one place.
TEST(Network, ANodeIsInTheMiddleOfThePlacesWhereMostArmsMeet) {
  const Network n = network({axis(1, {{-60, 0}, {0, 0}}), axis(2, {{0, 0}, {60, 10}}),
                             axis(3, {{-50, -40}, {0.3, 0}, {50, -40}})},
                            0.5, Crossing::over);
  ASSERT_EQ(degree(n, {0.15, 0}), 4);
  EXPECT_NEAR(distance(n.nodes[1].point, {0.15, 0}), 0, 1e-12);
}

// Whichever axis is numbered first, and from whichever end it is drawn.
TEST(Network, CrossingsThatJoinLieInTheMiddle) {
  const Line lines[] = {{{-50, 0}, {50, 0}}, {{0, -50}, {0, 50}}, {{-50.2, -50}, {50, 50.1}}};
  std::vector<Point> places;
  int order[] = {0, 1, 2};
  do {
    for (const bool back : {false, true}) {
      std::vector<NetworkAxis> axes;
      for (int id = 1; id <= 3; ++id) {
        const Line& line = lines[order[id - 1]];
        axes.push_back(axis(id, back ? reversed(line) : line));
      }
      const Network n = network(axes, 0.5, Crossing::split);
      ASSERT_EQ(n.nodes.size(), 7u);
      for (const Node& node : n.nodes)
        if (norm(node.point) < 1) places.push_back(node.point);
    }
  } while (std::next_permutation(order, order + 3));
  ASSERT_EQ(places.size(), 12u);
  for (const Point& place : places) EXPECT_NEAR(distance(place, places[0]), 0, 1e-9);
}

// A crossing goes to the nearer one of two nodes beside it on the same axis.
TEST(Network, ACrossingIsTheNearerNode) {
  for (const bool back : {false, true}) {
    const Line street{{-50, 0}, {-0.45, 0}, {0.2, 0}, {50, 0}};
    const Network n = network(
        {axis(1, back ? reversed(street) : street), axis(2, {{-30, 40}, {-0.45, 0}, {-40, -30}}),
         axis(3, {{30, 40}, {0.2, 0}, {40, -30}}), axis(4, {{0, -50}, {0, 50}})},
        0.5, Crossing::split);
    ASSERT_EQ(n.nodes.size(), 10u) << back;
    const auto at = std::find_if(n.nodes.begin(), n.nodes.end(), [](const Node& node) {
      return distance(node.point, {0.2, 0}) < 1e-9;
    });
    ASSERT_NE(at, n.nodes.end()) << back;
    const int node = static_cast<int>(at - n.nodes.begin());
    int arms = 0;
    for (const Edge& edge : n.edges) arms += (edge.from_node == node) + (edge.to_node == node);
    EXPECT_EQ(arms, 6) << back;
  }
}

TEST(Network, LevelsMeetOnlyAtAnEnd) {
  const Network over =
      network({axis(1, {{0, 0}, {50, 0}, {100, 0}}, 0), axis(2, {{50, -50}, {50, 0}, {50, 50}}, 1)},
              0.5, Crossing::split);
  EXPECT_EQ(over.edges.size(), 2u);
  const Network meet =
      network({axis(1, {{0, 0}, {50, 0}, {100, 0}}, 0), axis(2, {{50, 0}, {50, 50}}, 1)}, 0.5,
              Crossing::over);
  EXPECT_EQ(degree(meet, {50, 0}), 3);
}

TEST(Network, ReportsCrossingsAndSplitsThemOnDemand) {
  const std::vector<NetworkAxis> axes{axis(1, {{0, 0}, {100, 0}}), axis(2, {{50, -50}, {50, 50}})};
  const Network over = network(axes, 0.5, Crossing::over);
  EXPECT_EQ(over.edges.size(), 2u);
  ASSERT_EQ(over.reports.size(), 1u);
  EXPECT_EQ(over.reports[0].issue, NetworkIssue::crossing);
  const Network split = network(axes, 0.5, Crossing::split);
  EXPECT_EQ(split.edges.size(), 4u);
  EXPECT_TRUE(split.reports.empty());
}

TEST(Network, ReportsAClusterWiderThanThreeTolerancesAndDoesNotJoinIt) {
  std::vector<NetworkAxis> axes;
  for (int i = 0; i < 6; ++i) axes.push_back(axis(i + 1, {{0.4 * i, 0}, {0.4 * i, 50}}));
  const Network n = network(axes, 0.5, Crossing::over);
  EXPECT_TRUE(std::any_of(n.reports.begin(), n.reports.end(), [](const NetworkReport& r) {
    return r.issue == NetworkIssue::wide_cluster && r.measure > 1.5;
  }));
  EXPECT_EQ(n.nodes.size(), 12u);
}

TEST(Network, EndsOnEitherSideOfAnAxisMakeOneNode) {
  for (const double apart : {0.0, 1e-9, 0.01, 0.3, 0.49, 0.6}) {
    const Network n = network({axis(1, {{0, 0}, {100, 0}}), axis(2, {{50, 0.4}, {50, 60}}),
                               axis(3, {{50 + apart, -0.4}, {50 + apart, -60}})},
                              0.5, Crossing::over);
    EXPECT_EQ(n.edges.size(), apart < 0.5 ? 4u : 5u) << apart;
    EXPECT_EQ(degree(n, {50, 0}), apart < 0.5 ? 4 : 6) << apart;
    EXPECT_TRUE(n.reports.empty()) << apart;
  }
}

// Every 0.4 m an end on the other side: 2 m of them, or 1.2 m.
TEST(Network, ReportsAChainOfEndsAlongAnAxisWiderThanThreeTolerances) {
  for (const int ends : {6, 4}) {
    std::vector<NetworkAxis> axes{axis(1, {{0, 0}, {100, 0}})};
    for (int i = 0; i < ends; ++i) {
      const double x = 50 + 0.4 * i, side = i % 2 == 0 ? 1 : -1;
      axes.push_back(axis(i + 2, {{x, 0.3 * side}, {x, 50 * side}}));
    }
    const Network n = network(axes, 0.5, Crossing::over);
    EXPECT_EQ(n.reports.size(), ends == 6 ? 1u : 0u);
    EXPECT_EQ(n.edges.size(), ends == 6 ? 13u : 6u);
    if (n.reports.empty()) continue;
    EXPECT_EQ(n.reports[0].issue, NetworkIssue::wide_cluster);
    EXPECT_NEAR(n.reports[0].measure, std::hypot(2, 0.6), 1e-9);
  }
}

TEST(Network, AnAxisShorterThanTheToleranceCollapses) {
  const Network n = network({axis(1, {{0, 0}, {0.3, 0}})}, 0.5, Crossing::over);
  EXPECT_TRUE(n.edges.empty());
  ASSERT_EQ(n.reports.size(), 1u);
  EXPECT_EQ(n.reports[0].issue, NetworkIssue::collapsed_axis);
}

// A long axis with side streets that end anywhere on it, on either side and through it.
std::vector<NetworkAxis> comb(std::mt19937_64& random) {
  const auto share = [&] { return (random() % 100001) / 100000.0; };
  const double turn = 7 * share();
  const Point along{std::cos(turn), std::sin(turn)}, across{-along.y, along.x};
  const Point start{650000 + 1000 * share(), 6860000 + 1000 * share()};
  std::vector<NetworkAxis> axes{axis(1, {start, start + along * 60})};
  for (int i = 0; i < 12; ++i) {
    const Point foot = start + along * (1 + 58 * share());
    const double side = random() % 2 == 0 ? 1 : -1;
    const double apart = side * (random() % 4 == 0 ? -20 : 0.49 * share());
    axes.push_back(axis(i + 2, {foot + across * apart, foot + across * (side * (20 + 9 * i))}));
  }
  return axes;
}

TEST(Network, AnAxisIsCutNowhereTwiceWithinTheTolerance) {
  std::mt19937_64 random(11);
  const double tolerance = 0.5;
  int whole = 0;
  for (int round = 0; round < 300; ++round) {
    std::vector<NetworkAxis> axes = comb(random);
    const Network n = network(axes, tolerance, Crossing::split);
    const bool wide = std::any_of(n.reports.begin(), n.reports.end(), [](const NetworkReport& r) {
      return r.issue == NetworkIssue::wide_cluster;
    });
    whole += !wide;
    for (std::size_t e = 0; e < n.edges.size(); ++e) {
      const Edge& edge = n.edges[e];
      EXPECT_TRUE(wide || edge.end_abscissa - edge.start_abscissa > tolerance) << round;
      for (const auto& [at, node] : {std::pair(edge.start_abscissa, edge.from_node),
                                     std::pair(edge.end_abscissa, edge.to_node)}) {
        const Line& line = axes[edge.axis_id - 1].line;
        EXPECT_LE(distance(position_at(line, at).point, n.nodes[node].point), 3 * tolerance)
            << round;
      }
      // Not severed.
      if (e > 0 && n.edges[e - 1].axis_id == edge.axis_id) {
        EXPECT_EQ(n.edges[e - 1].to_node, edge.from_node) << round;
      }
    }
    std::shuffle(axes.begin(), axes.end(), random);
    const Network other = network(axes, tolerance, Crossing::split);
    ASSERT_EQ(n.edges.size(), other.edges.size()) << round;
    ASSERT_EQ(n.reports.size(), other.reports.size()) << round;
    for (std::size_t e = 0; e < n.edges.size(); ++e) {
      EXPECT_EQ(n.edges[e].start_abscissa, other.edges[e].start_abscissa);
      EXPECT_EQ(n.edges[e].to_node, other.edges[e].to_node);
    }
    for (std::size_t i = 0; i < n.nodes.size(); ++i)
      EXPECT_EQ(distance(n.nodes[i].point, other.nodes[i].point), 0);
  }
  EXPECT_GT(whole, 100);
}

TEST(Network, AClosedAxisIsOneLoop) {
  const Network n = network({axis(1, {{0, 0}, {40, 0}, {40, 40}, {0, 0}})}, 0.5, Crossing::over);
  ASSERT_EQ(n.edges.size(), 1u);
  EXPECT_EQ(n.edges[0].from_node, n.edges[0].to_node);
}

TEST(Network, DoesNotDependOnTheOrderOfTheAxes) {
  std::mt19937_64 random(3);
  std::vector<NetworkAxis> axes;
  const auto jitter = [&] { return (random() % 1000) / 1000.0 * 0.25; };
  for (int x = 0; x < 8; ++x)
    for (int y = 0; y < 8; ++y) {
      axes.push_back(axis(axes.size() + 1, {{50. * x + jitter(), 50. * y + jitter()},
                                            {50. * x + 50 + jitter(), 50. * y + jitter()}}));
      axes.push_back(axis(axes.size() + 1, {{50. * x + jitter(), 50. * y + jitter()},
                                            {50. * x + jitter(), 50. * y + 50 + jitter()}}));
    }
  const Network first = network(axes, 0.5, Crossing::split);
  // Rough by half the tolerance, the clean grid's topology: 81 places less the far corner.
  EXPECT_EQ(first.nodes.size(), 80u);
  EXPECT_EQ(first.edges.size(), axes.size());
  std::shuffle(axes.begin(), axes.end(), random);
  const Network second = network(axes, 0.5, Crossing::split);
  ASSERT_EQ(first.nodes.size(), second.nodes.size());
  for (std::size_t i = 0; i < first.nodes.size(); ++i)
    EXPECT_EQ(distance(first.nodes[i].point, second.nodes[i].point), 0);
  for (std::size_t i = 0; i < first.edges.size(); ++i) {
    const Edge& edge = first.edges[i];
    EXPECT_EQ(edge.axis_id, second.edges[i].axis_id);
    EXPECT_EQ(distance(edge.line.front(), first.nodes[edge.from_node].point), 0);
    EXPECT_EQ(distance(edge.line.back(), first.nodes[edge.to_node].point), 0);
  }
}

}  // namespace network_test
}  // namespace streetgen
