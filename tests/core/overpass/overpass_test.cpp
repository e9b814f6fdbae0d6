#include "streetgen/overpass.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "geometry/polyline.hpp"

namespace streetgen {
namespace overpass_test {

struct Town {
  Network net;
  std::vector<int> importances;
  std::vector<double> axis_lengths;
};

Town town(const std::vector<NetworkAxis>& axes, std::vector<int> importance_of_axis = {}) {
  Town made{network(axes, 0.5, Crossing::over), {}, {}};
  for (const Edge& edge : made.net.edges) {
    for (const NetworkAxis& axis : axes)
      if (axis.axis_id == edge.axis_id) made.axis_lengths.push_back(length(axis.line));
    made.importances.push_back(
        importance_of_axis.empty()
            ? 4
            : importance_of_axis[static_cast<std::size_t>(edge.axis_id) - 1]);
  }
  return made;
}

std::vector<Overpass> found(const Town& made, const std::vector<OverpassOverride>& by_hand = {}) {
  return overpasses(made.net, made.importances, made.axis_lengths, by_hand, 0.5, 6);
}

std::int64_t above(const Town& made, const Overpass& overpass) {
  return made.net.edges[overpass.edge_above].axis_id;
}

const Line west_east{{0, 0}, {100, 0}}, south_north{{50, -50}, {50, 50}};

TEST(Overpass, HasTheHigherLevelAbove) {
  const Town made = town({{1, west_east, 1}, {2, south_north, 0}});
  const std::vector<Overpass> all = found(made);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(above(made, all[0]), 1);
  EXPECT_EQ(all[0].method, OverpassMethod::level);
  EXPECT_DOUBLE_EQ(all[0].abscissa_above, 50);
  EXPECT_DOUBLE_EQ(all[0].clearance, 6);
}

TEST(Overpass, HasTheMoreImportantAxisAboveWhereLevelsAreEqual) {
  const Town made = town({{1, west_east}, {2, south_north}}, {2, 4});
  EXPECT_EQ(above(made, found(made).at(0)), 1);
  EXPECT_EQ(found(made)[0].method, OverpassMethod::importance);
  const Town equal = town({{1, west_east}, {2, south_north}});
  EXPECT_EQ(above(equal, found(equal).at(0)), 2);
}

TEST(Overpass, CountsACrossingAtAVertexOnce) {
  const Town made =
      town({{1, {{0, 0}, {50, 0}, {100, 0}}, 1}, {2, {{50, -50}, {50, 0}, {50, 50}}}});
  EXPECT_EQ(found(made).size(), 1u);
}

TEST(Overpass, CountsEachCrossingOfTwoAxes) {
  const Town made = town({{1, west_east, 1}, {2, {{20, -10}, {20, 10}, {60, 10}, {60, -10}}}});
  EXPECT_EQ(found(made).size(), 2u);
}

TEST(Overpass, IsNoneWhereEdgesMeetOrRunAlongEachOther) {
  EXPECT_TRUE(found(town({{1, west_east}, {2, {{50, 0}, {50, 50}}}})).empty());
  EXPECT_TRUE(found(town({{1, west_east, 1}, {2, {{10, 0}, {90, 0}}, 0}})).empty());
}

TEST(Overpass, HasTheLongerOfEqualAxesAboveWhateverTheirNumbers) {
  const Line longer{{0, 0}, {110, 0}};
  EXPECT_EQ(above(town({{1, longer}, {2, south_north}}),
                  found(town({{1, longer}, {2, south_north}})).at(0)),
            1);
  EXPECT_EQ(above(town({{2, longer}, {1, south_north}}),
                  found(town({{2, longer}, {1, south_north}})).at(0)),
            2);
}

TEST(Overpass, OfALoopIsAboveNearerToItsMiddleWhicheverWayItIsDrawn) {
  Line line{{30, 0}, {100, 0}, {100, 50}, {50, 50}, {50, -50}};
  const Overpass drawn = found(town({{1, line}})).at(0);
  EXPECT_DOUBLE_EQ(drawn.abscissa_above, 220);
  std::reverse(line.begin(), line.end());
  EXPECT_DOUBLE_EQ(found(town({{1, line}})).at(0).abscissa_above, 50);
  const Town even = town({{1, {{0, 0}, {100, 0}, {100, 50}, {50, 50}, {50, -50}}}});
  EXPECT_GT(found(even).at(0).abscissa_above, found(even).at(0).abscissa_below)
      << "the later place of a loop with equal ends";
}

// The same axis, cut in the middle of its loop by a street that meets it.
TEST(Overpass, OfTwoEdgesOfOneAxisIsAboveNearerToItsMiddle) {
  Line line{{30, 0}, {100, 0}, {100, 50}, {50, 50}, {50, -70}};
  for (int way = 0; way < 2; ++way) {
    const Town made = town({{1, line}, {2, {{100, 50}, {150, 90}}}});
    const std::vector<Overpass> all = found(made);
    ASSERT_EQ(all.size(), 1u);
    const Edge& edge = made.net.edges[all[0].edge_above];
    EXPECT_NEAR(edge.end_abscissa - edge.start_abscissa, 170, 1e-9);
    std::reverse(line.begin(), line.end());
  }
}

TEST(Overpass, IsTurnedRoundByHandWithItsClearance) {
  const Town made = town({{1, west_east, 1}, {2, south_north}});
  const std::vector<Overpass> all = found(made, {{{52, 3}, 2, 1, 5.2}});
  EXPECT_EQ(above(made, all.at(0)), 2);
  EXPECT_EQ(all[0].method, OverpassMethod::by_hand);
  EXPECT_DOUBLE_EQ(all[0].clearance, 5.2);
  EXPECT_EQ(above(made, found(made, {{{50, 30}, 2, 1, {}}}).at(0)), 1)
      << "too far from the crossing";
}

// Levels are drawn at random, so that some crossings have a node and most have none.
TEST(Overpass, FindsWhatEveryPairOfSegmentsSays) {
  std::mt19937_64 random(7);
  for (int round = 0; round < 20; ++round) {
    std::vector<NetworkAxis> axes;
    for (int i = 1; i <= 30; ++i) {
      const auto place = [&] { return Point{random() % 10000 / 20.0, random() % 10000 / 20.0, 0}; };
      axes.push_back({i, {place(), place(), place()}, static_cast<int>(random() % 4)});
    }
    const Town made = town(axes);
    std::size_t crossings = 0;
    const std::vector<Edge>& edges = made.net.edges;
    for (std::size_t a = 0; a < edges.size(); ++a)
      for (std::size_t b = a + 1; b < edges.size(); ++b)
        for (std::size_t i = 1; i < edges[a].line.size(); ++i)
          for (std::size_t j = 1; j < edges[b].line.size(); ++j) {
            const auto at = crossing(edges[a].line[i - 1], edges[a].line[i], edges[b].line[j - 1],
                                     edges[b].line[j]);
            if (!at) continue;
            bool node = false;
            for (const Node& shared : made.net.nodes)
              node = node || distance(shared.point, *at) <= 0.5;
            crossings += !node;
          }
    std::size_t between = 0;
    for (const Overpass& overpass : found(made))
      between += overpass.edge_above != overpass.edge_below;
    EXPECT_EQ(between, crossings) << "round " << round;
  }
}

}  // namespace overpass_test
}  // namespace streetgen
