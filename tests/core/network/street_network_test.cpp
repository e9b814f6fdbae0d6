#include "streetgen/street_network.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "geometry/polyline.hpp"

namespace streetgen {
namespace street_network_test {

StreetAxis street(std::int64_t id, Line line, double width = 8) {
  StreetAxis axis;
  axis.axis_id = id;
  axis.line = std::move(line);
  axis.width = axis.width_end = width;
  return axis;
}

Network of(const std::vector<StreetAxis>& axes) {
  return street_network(axes, 0.5, Crossing::over);
}

std::vector<NetworkReport> told(const Network& network, NetworkIssue issue) {
  std::vector<NetworkReport> reports;
  for (const NetworkReport& report : network.reports)
    if (report.issue == issue) reports.push_back(report);
  return reports;
}

double metres_of(const Network& network, std::int64_t axis_id) {
  double sum = 0;
  for (const Edge& edge : network.edges)
    if (edge.axis_id == axis_id) sum += length(edge.line);
  return sum;
}

// A street of 300 m between two that it meets, with control points.
std::vector<StreetAxis> block(std::vector<ControlPoint> controls) {
  std::vector<StreetAxis> axes{street(1, {{0, 0}, {300, 0}}),
                               street(2, {{0, -50}, {0, 0}, {0, 50}}),
                               street(3, {{300, -50}, {300, 0}, {300, 50}})};
  axes[0].controls = std::move(controls);
  return axes;
}

std::vector<double> starts_of_first(const Network& network) {
  std::vector<double> starts;
  for (const Edge& edge : network.edges)
    if (edge.axis_id == 1) starts.push_back(edge.start_abscissa);
  return starts;
}

TEST(CutAtSignals, AVertexNearTheSignalsTakesTheCutOnce) {
  for (const double place : {119.7, 120.0, 120.0 + 1e-10, 120.3}) {
    std::vector<StreetAxis> axes = block({{1, place, ControlKind::signals}});
    axes[0].line = {{0, 0}, {60, 0}, {120, 0}, {200, 0}, {300, 0}};
    const Network cut = of(axes);
    ASSERT_EQ(starts_of_first(cut), (std::vector<double>{0, 120})) << place;
    EXPECT_EQ(cut.edges[0].line.size(), 3u);
    EXPECT_EQ(cut.edges[1].line.size(), 3u);
    EXPECT_EQ(cut.edges[1].line.front().x, 120);
  }
}

TEST(CutAtSignals, SignalsInMidBlockStandOnANodeOfTheirOwn) {
  const Network cut = of(block({{1, 120, ControlKind::signals}}));
  EXPECT_EQ(starts_of_first(cut), (std::vector<double>{0, 120}));
  EXPECT_EQ(cut.edges[0].to_node, cut.edges[1].from_node);
  const Node& node = cut.nodes[cut.edges[0].to_node];
  EXPECT_EQ(node.point.x, 120);
  ASSERT_EQ(node.anchors.size(), 1u);
  EXPECT_EQ(node.anchors[0].axis_id, 1);
  EXPECT_EQ(node.anchors[0].abscissa, 120);
  for (std::size_t n = 1; n < cut.nodes.size(); ++n) {
    const NodeAnchor &a = cut.nodes[n - 1].anchors[0], &b = cut.nodes[n].anchors[0];
    EXPECT_LT(std::pair(a.axis_id, a.abscissa), std::pair(b.axis_id, b.abscissa));
  }
}

TEST(CutAtSignals, NearAJunctionOrOfAnotherKindTheyCutNothing) {
  using Direction = ControlPoint::Direction;
  for (const ControlPoint& point : {ControlPoint{1, 255, ControlKind::signals},
                                    {1, 45, ControlKind::signals},
                                    {1, 20, ControlKind::signals, Direction::along},
                                    {1, 120, ControlKind::stop},
                                    {1, 120, ControlKind::pedestrian_crossing},
                                    {2, 120, ControlKind::signals}})
    EXPECT_EQ(starts_of_first(of(block({point}))), (std::vector<double>{0})) << point.abscissa;
  // More than a queue behind the junction, and with another far ahead.
  EXPECT_EQ(starts_of_first(of(block({{1, 30, ControlKind::signals, Direction::along}}))),
            (std::vector<double>{0, 30}));
}

TEST(CutAtSignals, SignalsWithinAQueueAreOnePlaceAtTheCrossingBetweenThem) {
  const ControlPoint first{1, 120, ControlKind::signals}, second{1, 140, ControlKind::signals};
  EXPECT_EQ(starts_of_first(of(block({second, first}))), (std::vector<double>{0, 130}));
  EXPECT_EQ(starts_of_first(of(block({first, second, {1, 126, ControlKind::pedestrian_crossing}}))),
            (std::vector<double>{0, 126}));
  EXPECT_EQ(starts_of_first(of(block({first, {1, 150, ControlKind::signals}}))),
            (std::vector<double>{0, 120, 150}));
}

TEST(CutAtSignals, OnePlaceIsNoLongerThanAQueue) {
  std::vector<ControlPoint> row;
  for (const double abscissa : {100.0, 120.0, 140.0, 160.0})
    row.push_back({1, abscissa, ControlKind::signals});
  EXPECT_EQ(starts_of_first(of(block(row))), (std::vector<double>{0, 110, 150}));
}

// Signals with the crossing that they are there for.
std::vector<ControlPoint> lit_crossing(double abscissa, double crossing,
                                       ControlPoint::Direction direction = {}) {
  return {{1, abscissa, ControlKind::signals, direction},
          {1, crossing, ControlKind::pedestrian_crossing}};
}

TEST(CutAtSignals, SignalsOfACrossingThatIsOfNoArmStandInMidBlock) {
  using Direction = ControlPoint::Direction;
  EXPECT_EQ(starts_of_first(of(block(lit_crossing(260, 260)))), (std::vector<double>{0, 260}));
  EXPECT_EQ(starts_of_first(of(block(lit_crossing(40, 37)))), (std::vector<double>{0, 40}));
  EXPECT_EQ(starts_of_first(of(block(lit_crossing(22, 22, Direction::along)))),
            (std::vector<double>{0, 22}));
  for (const auto& [signals, crossing] : {std::pair{288.0, 288.0}, {278.0, 282.0}, {260.0, 240.0}})
    EXPECT_EQ(starts_of_first(of(block(lit_crossing(signals, crossing)))), (std::vector<double>{0}))
        << signals;
}

TEST(CutAtSignals, BesideARoundaboutTheyStandInMidBlockButForItsEntry) {
  std::vector<StreetAxis> axes = block({});
  axes[1].on_ring = axes[2].on_ring = true;
  const auto starts = [&](std::vector<ControlPoint> controls) {
    axes[0].controls = std::move(controls);
    return starts_of_first(of(axes));
  };
  EXPECT_EQ(starts(lit_crossing(288, 288)), (std::vector<double>{0, 288}));
  EXPECT_EQ(starts(lit_crossing(296, 296)), (std::vector<double>{0, 296}));
  EXPECT_EQ(starts({{1, 288, ControlKind::signals}}), (std::vector<double>{0, 288}));
  EXPECT_EQ(starts({{1, 3, ControlKind::signals, ControlPoint::Direction::along}}),
            (std::vector<double>{0, 3}));
  EXPECT_EQ(starts({{1, 296, ControlKind::signals}}), (std::vector<double>{0}));
}

TEST(CutAtSignals, SignalsWhereTwoAxesMeetStandThere) {
  std::vector<StreetAxis> axes = block({});
  axes[0].line = {{0, 0}, {150, 0}};
  axes.push_back(street(4, {{150, 0}, {300, 0}}));
  axes[3].controls = {{4, 1, ControlKind::signals}};
  EXPECT_EQ(of(axes).edges.size(), of(block({})).edges.size() + 1);
}

TEST(Twin, OfTwoNamesForOneStreetTheLaterOneIsNone) {
  const Network n = of({street(1, {{0, 0}, {100, 0}, {200, 0}}), street(2, {{200, 0}, {0, 0}})});
  EXPECT_EQ(metres_of(n, 1), 200);
  EXPECT_EQ(metres_of(n, 2), 0);
  const auto reports = told(n, NetworkIssue::lies_on_another);
  ASSERT_EQ(reports.size(), 1u);
  EXPECT_EQ(reports[0].axis_a, 2);
  EXPECT_EQ(reports[0].axis_b, 1);
  EXPECT_NEAR(reports[0].measure, 200, 1e-9);
  EXPECT_NEAR(distance(reports[0].point, {100, 0}), 0, 1e-9);
}

TEST(Twin, TheMoreImportantThenTheWiderOneIsTheStreet) {
  std::vector<StreetAxis> axes{street(1, {{0, 0}, {100, 0}}, 6), street(2, {{0, 0}, {100, 0}}, 7)};
  EXPECT_EQ(metres_of(of(axes), 1), 0);
  axes[0].importance = 2;
  EXPECT_EQ(metres_of(of(axes), 2), 0);
}

TEST(Twin, APartOfALongerLineWithOtherVertices) {
  const Network n = of({street(1, {{0, 0}, {40, 0}, {60, 0}, {200, 0}}, 9),
                        street(2, {{150, 0}, {60, 0}, {40, 0}, {40, 90}}, 6)});
  EXPECT_NEAR(metres_of(n, 2), 90, 1e-9);
  const auto reports = told(n, NetworkIssue::lies_on_another);
  ASSERT_EQ(reports.size(), 1u);
  EXPECT_NEAR(reports[0].measure, 110, 1e-9);
}

// Two centre lines of one street of 8 m lie on each other up to a quarter of that; two
// carriageways do not.
TEST(Twin, WithinTheMiddleHalfOfItsStreet) {
  for (const double apart : {0.4, 1.0, 1.9, 2.1, 4.0}) {
    const Network n = of({street(1, {{0, 0}, {20, 0}, {180, 0}, {200, 0}}),
                          street(2, {{0, 0}, {20, apart}, {180, apart}, {200, 0}})});
    EXPECT_EQ(metres_of(n, 2) == 0, apart < 2) << apart;
  }
}

TEST(Twin, BesideItWhereItsOffsetSaysSo) {
  std::vector<StreetAxis> axes{street(1, {{0, 0}, {100, 0}}), street(2, {{100, 0}, {0, 0}})};
  axes[0].roadway_offset = axes[1].roadway_offset = 4;
  EXPECT_GT(metres_of(of(axes), 2), 0);
  axes[1].roadway_offset = -4;
  EXPECT_EQ(metres_of(of(axes), 2), 0);
}

TEST(Twin, OnAnotherLevelIsAStreet) {
  std::vector<StreetAxis> axes{street(1, {{0, 0}, {100, 0}}), street(2, {{0, 0}, {100, 0}})};
  axes[1].level = 1;
  const Network n = of(axes);
  EXPECT_EQ(metres_of(n, 2), 100);
  EXPECT_TRUE(told(n, NetworkIssue::lies_on_another).empty());
}

TEST(Twin, ThatAloneLeadsInItsDirectionStaysAndIsTold) {
  std::vector<StreetAxis> axes{street(1, {{0, 0}, {100, 0}}), street(2, {{100, 0}, {0, 0}})};
  for (const bool along : {true, false}) {
    axes[0].leads_backward = false;
    axes[1].leads_forward = !along;
    axes[1].leads_backward = along;
    const Network n = of(axes);
    EXPECT_EQ(metres_of(n, 2), along ? 0 : 100);
    EXPECT_EQ(told(n, NetworkIssue::lies_on_another).size(), 1u);
  }
}

// A side street that ends at the twin, too far from the other one to meet it.
TEST(Twin, ThatAloneLeadsToAStreetStaysAndIsTold) {
  std::vector<StreetAxis> axes{street(1, {{0, 0}, {10, -1}, {100, -1}, {110, 0}}),
                               street(2, {{0, 0}, {10, 0.5}, {50, 0.5}, {100, 0.5}, {110, 0}}),
                               street(3, {{50, 0.5}, {50, 60}})};
  const Network n = of(axes);
  EXPECT_GT(metres_of(n, 2), 100);
  EXPECT_FALSE(told(n, NetworkIssue::lies_on_another).empty());
  axes[2].line[0] = {50, 3.4};
  EXPECT_EQ(metres_of(of(axes), 2), 0);
}

TEST(Twin, ShortWaysAcrossAndShortArmsOfAFlatForkAreStreets) {
  const Network across =
      of({street(1, {{0, 0}, {100, 0}}, 20), street(2, {{50, -4}, {50, 4}}, 20)});
  EXPECT_EQ(metres_of(across, 2), 8);
  const Network fork = of({street(1, {{0, 0}, {100, 0}}), street(2, {{0, 0}, {60, 6}})});
  EXPECT_GT(metres_of(fork, 2), 60);
  EXPECT_TRUE(told(fork, NetworkIssue::lies_on_another).empty());
}

TEST(Twin, ARingDrawnTwiceFromAnotherPlace) {
  const Line ring{{0, 0}, {30, 0}, {30, 30}, {0, 30}, {0, 0}};
  const Line turned{{30, 30}, {30, 0}, {0, 0}, {0, 30}, {30, 30}};
  const Network n = of({street(1, ring), street(2, turned), street(3, {{0, 0}, {-50, 0}})});
  EXPECT_NEAR(metres_of(n, 1), 120, 1e-9);
  EXPECT_EQ(metres_of(n, 2), 0);
}

TEST(MissedEnd, InTheRoadwayAndBeyondTheTolerance) {
  for (const double y : {0.0, 0.4, 0.7, 3.9, 4.1}) {
    const Network n = of({street(1, {{0, 0}, {100, 0}}), street(2, {{50, y}, {50, 60}})});
    const auto reports = told(n, NetworkIssue::misses);
    ASSERT_EQ(reports.size(), y > 0.5 && y < 4 ? 1u : 0u) << y;
    if (reports.empty()) continue;
    EXPECT_EQ(reports[0].axis_a, 2);
    EXPECT_EQ(reports[0].axis_b, 1);
    EXPECT_NEAR(reports[0].measure, y, 1e-9);
    // The tolerance that would join them does.
    const Network wider =
        street_network({street(1, {{0, 0}, {100, 0}}), street(2, {{50, y}, {50, 60}})},
                       reports[0].measure, Crossing::over);
    EXPECT_EQ(wider.edges.size(), 3u);
  }
}

TEST(MissedEnd, GoesBeyondTheOtherAxis) {
  const std::vector<StreetAxis> axes{street(1, {{0, 0}, {100, 0}}),
                                     street(2, {{50, -1}, {50, 60}})};
  EXPECT_EQ(told(of(axes), NetworkIssue::misses).size(), 1u);
  // With a node where they cross, what is left is a stub in the roadway.
  EXPECT_TRUE(told(street_network(axes, 0.5, Crossing::split), NetworkIssue::misses).empty());
}

// A neighbour that is joined bends the edge towards this end, not the axis.
TEST(MissedEnd, BesideAnEndThatIsJoined) {
  const std::vector<StreetAxis> axes{street(1, {{0, 0}, {100, 0}}),
                                     street(2, {{52, 0.45}, {60, 60}}),
                                     street(3, {{50, 0.56}, {40, 60}})};
  const Network n = of(axes);
  EXPECT_EQ(n.edges.size(), 4u);
  const auto reports = told(n, NetworkIssue::misses);
  ASSERT_EQ(reports.size(), 1u);
  EXPECT_EQ(reports[0].axis_a, 3);
  EXPECT_NEAR(reports[0].measure, 0.56, 1e-9);
  EXPECT_EQ(street_network(axes, reports[0].measure, Crossing::over).edges.size(), 5u);
}

TEST(MissedEnd, ABridgeOverARoadIsNone) {
  std::vector<StreetAxis> axes{street(1, {{0, 0}, {100, 0}}), street(2, {{50, 1}, {50, 60}})};
  axes[1].level = 1;
  EXPECT_TRUE(told(of(axes), NetworkIssue::misses).empty());
}

TEST(MissedEnd, OfTwoThatMissEachOtherTheLaterOneIsTold) {
  const auto reports =
      told(of({street(1, {{0, 0}, {50, 0}}), street(2, {{52, 0}, {90, 0}})}), NetworkIssue::misses);
  ASSERT_EQ(reports.size(), 1u);
  EXPECT_EQ(reports[0].axis_a, 2);
}

TEST(MissedEnd, TheRoadwayMayLieBesideItsAxis) {
  for (const double offset : {4.0, -4.0}) {
    std::vector<StreetAxis> axes{street(1, {{0, 0}, {100, 0}}), street(2, {{50, 6}, {50, 60}})};
    axes[0].roadway_offset = offset;
    EXPECT_EQ(told(of(axes), NetworkIssue::misses).size(), offset > 0 ? 1u : 0u);
  }
}

// Whatever the order of the axes, and from whichever end they are drawn.
TEST(StreetNetwork, IsTheSameInAnyOrder) {
  std::mt19937 random(7);
  const auto number = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int round = 0; round < 60; ++round) {
    std::vector<StreetAxis> axes;
    for (int i = 0; i < 6; ++i) {
      Line line{{0, 40.0 * i}, {number(60, 90), 40.0 * i + number(-3, 3)}, {160, 40.0 * i}};
      axes.push_back(street(2 * i, line, number(5, 12)));
      const double aside = number(0, 3);
      for (Point& p : line) p.y += aside;
      if (i % 2) std::reverse(line.begin(), line.end());
      axes.push_back(street(2 * i + 1, line, number(5, 12)));
      axes.push_back(street(
          20 + i, {{number(0, 160), 40.0 * i + number(0, 5)}, {number(0, 160), 40.0 * i + 36}}));
    }
    const Network one = of(axes);
    std::shuffle(axes.begin(), axes.end(), random);
    const Network two = of(axes);
    ASSERT_EQ(one.edges.size(), two.edges.size());
    ASSERT_EQ(one.reports.size(), two.reports.size());
    for (StreetAxis& axis : axes) {
      std::reverse(axis.line.begin(), axis.line.end());
      std::swap(axis.leads_forward, axis.leads_backward);
    }
    const Network back = of(axes);
    EXPECT_EQ(one.edges.size(), back.edges.size());
    EXPECT_EQ(one.reports.size(), back.reports.size());
    for (const Edge& edge : one.edges)
      for (const int n : {edge.from_node, edge.to_node})
        EXPECT_LT(n, static_cast<int>(one.nodes.size()));
  }
}

}  // namespace street_network_test
}  // namespace streetgen
