#include "streetgen/network.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "../../src/core/polyline.hpp"

namespace streetgen {
namespace {

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
  EXPECT_EQ(network(axes, 0.5, Crossing::split).edges.size(), 4u);
}

TEST(Network, ReportsAClusterWiderThanThreeTolerancesAndDoesNotJoinIt) {
  std::vector<NetworkAxis> axes;
  for (int i = 0; i < 6; ++i) axes.push_back(axis(i + 1, {{0.4 * i, 0}, {0.4 * i, 50}}));
  const Network n = network(axes, 0.5, Crossing::over);
  EXPECT_TRUE(std::any_of(n.reports.begin(), n.reports.end(), [](const NetworkReport& r) {
    return r.issue == NetworkIssue::wide_cluster && r.measure > 1.5;
  }));
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

}  // namespace
}  // namespace streetgen
