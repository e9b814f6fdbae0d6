// What lies beside edges: medians, splitters, islands, or the city.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>

#include "streetgen/streets.hpp"

namespace streetgen {
namespace ground_beside_test {

enum Way { both, along };

StreetAxis axis(std::int64_t id, Line line, Way way, std::int64_t street = 0, double width = 7) {
  StreetAxis axis{id, std::move(line), 0, width, width, 6, 3};
  axis.leads_backward = way == both;
  axis.street = street;
  return axis;
}

Point turned(const Point& p, double angle) {
  return {p.x * std::cos(angle) - p.y * std::sin(angle),
          p.x * std::sin(angle) + p.y * std::cos(angle), 0};
}

// By axis, its left and its right: of its only edge.
std::map<std::int64_t, std::pair<Beside, Beside>> beside(const std::vector<StreetAxis>& axes) {
  const Streets town = streets(axes, StreetSettings{});
  std::map<std::int64_t, std::pair<Beside, Beside>> found;
  for (std::size_t e = 0; e < town.network.edges.size(); ++e)
    EXPECT_TRUE(found
                    .insert({town.network.edges[e].axis_id,
                             {town.beside.sides[2 * e], town.beside.sides[2 * e + 1]}})
                    .second);
  return found;
}

// As it is, with traffic on the left, drawn against the traffic, and turned about.
void expect_beside(const std::vector<StreetAxis>& axes,
                   const std::map<std::int64_t, std::pair<Beside, Beside>>& wanted) {
  EXPECT_EQ(beside(axes), wanted);
  std::vector<StreetAxis> left = axes;
  for (StreetAxis& one : left)
    if (!(one.leads_forward && one.leads_backward))
      std::swap(one.leads_forward, one.leads_backward);
  EXPECT_EQ(beside(left), wanted) << "traffic on the left";
  std::vector<StreetAxis> backward = left;
  std::map<std::int64_t, std::pair<Beside, Beside>> mirrored = wanted;
  for (StreetAxis& one : backward) one.line = {one.line.rbegin(), one.line.rend()};
  for (auto& [id, sides] : mirrored) std::swap(sides.first, sides.second);
  EXPECT_EQ(beside(backward), mirrored) << "drawn backward";
  for (const double angle : {0.4, 1.7, 3.1}) {
    std::vector<StreetAxis> about = axes;
    for (StreetAxis& one : about)
      for (Point& p : one.line) p = turned(p, angle);
    EXPECT_EQ(beside(about), wanted) << angle;
  }
}

constexpr Beside outer = Beside::outer, median = Beside::median, splitter = Beside::splitter,
                 island = Beside::island;

// Two one-way streets so far apart, between their middles.
std::vector<StreetAxis> pair(double apart, std::int64_t street, std::int64_t other) {
  return {axis(1, {{0, 0, 0}, {300, 0, 0}}, along, street),
          axis(2, {{300, apart, 0}, {0, apart, 0}}, along, other)};
}

TEST(GroundBeside, IsAMedianBetweenCarriagewaysOfOneStreet) {
  expect_beside(pair(12, 5, 5), {{1, {median, outer}}, {2, {median, outer}}});
  expect_beside(pair(26.9, 5, 0), {{1, {median, outer}}, {2, {median, outer}}});
  expect_beside(pair(27.1, 5, 5), {{1, {outer, outer}}, {2, {outer, outer}}});
}

// At their common end the median lies on one side of the node, and the city about it on the other.
TEST(GroundBeside, IsTheCityAboutTheCommonEndOfTwoCarriageways) {
  for (const bool backward : {false, true}) {
    std::vector<StreetAxis> axes{axis(1, {{0, 0, 0}, {150, 15, 0}}, along, 5),
                                 axis(2, {{150, 15, 0}, {0, 30, 0}}, along, 5)};
    if (backward)
      for (StreetAxis& one : axes) {
        one.line = {one.line.rbegin(), one.line.rend()};
        std::swap(one.leads_forward, one.leads_backward);
      }
    const Streets town = streets(axes, StreetSettings{});
    ASSERT_EQ(town.network.edges.size(), 2u);
    // By the edge end that comes first about a corner, counter-clockwise: the start, the end.
    const std::vector<Beside>& corners = town.beside.corners;
    const Beside about = corners[backward ? 0 : 1], between = corners[backward ? 3 : 2];
    EXPECT_EQ(about, outer) << backward;
    EXPECT_EQ(between, median) << backward;
  }
}

TEST(GroundBeside, IsTheCityBetweenStreetsOfTwoNames) {
  expect_beside(pair(12, 5, 6), {{1, {outer, outer}}, {2, {outer, outer}}});
}

TEST(GroundBeside, IsTheCityBetweenStreetsOfOneDirection) {
  std::vector<StreetAxis> axes = pair(12, 5, 5);
  std::swap(axes[1].line.front(), axes[1].line.back());
  EXPECT_EQ(beside(axes), (std::map<std::int64_t, std::pair<Beside, Beside>>{{1, {outer, outer}},
                                                                             {2, {outer, outer}}}));
}

// Two estimated sidewalks have no room on it.
TEST(GroundBeside, IsAMedianWhereASeparatorPartsLanesOfOneDirection) {
  const auto along_each_other = [](double apart) {
    std::vector<StreetAxis> axes = pair(apart, 5, 5);
    std::swap(axes[1].line.front(), axes[1].line.back());
    return beside(axes);
  };
  EXPECT_EQ(along_each_other(10.9), (std::map<std::int64_t, std::pair<Beside, Beside>>{
                                        {1, {median, outer}}, {2, {outer, median}}}));
  EXPECT_EQ(along_each_other(11.1), (std::map<std::int64_t, std::pair<Beside, Beside>>{
                                        {1, {outer, outer}}, {2, {outer, outer}}}));
}

// A source draws one carriageway twice: the copy on the roadway is no street beside it.
TEST(GroundBeside, IsAMedianBesideACarriagewayDrawnTwice) {
  std::vector<StreetAxis> axes = pair(14, 5, 5);
  axes.push_back(axis(3, {{300, 13.5, 0}, {0, 13.5, 0}}, along, 5, 5));
  const auto found = beside(axes);
  EXPECT_EQ(found.at(1).first, median);
  EXPECT_EQ(found.at(2).first, median);
}

// It begins where the ground is 20 m wide at most, and goes on up to 30 m.
TEST(GroundBeside, IsAMedianAsCarriagewaysSpread) {
  const auto spreading = [](double widest) {
    return beside({axis(1, {{0, 0, 0}, {300, 0, 0}}, along, 5),
                   axis(2, {{300, 7 + widest, 0}, {0, 7 + 15, 0}}, along, 5)});
  };
  EXPECT_EQ(spreading(29), (std::map<std::int64_t, std::pair<Beside, Beside>>{
                               {1, {median, outer}}, {2, {median, outer}}}));
  EXPECT_EQ(spreading(70).at(1).first, outer);
}

TEST(GroundBeside, IsNoMedianBeyondAStreetBetween) {
  std::vector<StreetAxis> axes = pair(24, 5, 5);
  axes.push_back(axis(3, {{0, 12, 0}, {300, 12, 0}}, both, 5, 5));
  expect_beside(axes, {{1, {outer, outer}}, {2, {outer, outer}}, {3, {outer, outer}}});
}

TEST(GroundBeside, IsAMedianAlongMoreThanHalfOfAnEdge) {
  std::vector<StreetAxis> axes = pair(12, 5, 5);
  axes[1].line = {{140, 12, 0}, {0, 12, 0}};
  expect_beside(axes, {{1, {outer, outer}}, {2, {median, outer}}});
  axes[1].line = {{160, 12, 0}, {0, 12, 0}};
  expect_beside(axes, {{1, {median, outer}}, {2, {median, outer}}});
}

// The other carriageway begins and ends within the edge. Its part is known to the places at which
// the edge looks across, 5 m apart; what is shorter than 15 m is no part.
TEST(GroundBeside, KnowsTheStretchesOfAMedian) {
  const auto stretches = [](double from, double to, bool backward) {
    std::vector<StreetAxis> axes = pair(12, 5, 5);
    axes[1].line = {{to, 12, 0}, {from, 12, 0}};
    if (backward)
      for (StreetAxis& one : axes) one.line = {one.line.rbegin(), one.line.rend()};
    const Streets town = streets(axes, StreetSettings{});
    const int e = town.network.edges[0].axis_id == 1 ? 0 : 1;
    EXPECT_TRUE(town.beside.medians[2 * e + (backward ? 0 : 1)].empty());
    EXPECT_TRUE(town.beside.medians[2 * (1 - e)].empty());
    return town.beside.medians[2 * e + (backward ? 1 : 0)];
  };
  EXPECT_EQ(stretches(100, 220, false), (std::vector<double>{100, 220}));
  EXPECT_EQ(stretches(100, 220, true), (std::vector<double>{80, 200}));
  EXPECT_EQ(stretches(0, 140, false), (std::vector<double>{0, 140}));
  EXPECT_EQ(stretches(0, 290, false), std::vector<double>{});
  EXPECT_EQ(stretches(100, 110, false), std::vector<double>{});
}

TEST(GroundBeside, IsAMedianWhereALinkClosesIt) {
  std::vector<StreetAxis> axes = pair(16, 5, 5);
  axes.push_back(axis(3, {{300, 0, 0}, {300, 16, 0}}, both, 9));
  expect_beside(axes, {{1, {median, outer}}, {2, {median, outer}}, {3, {median, outer}}});
}

TEST(GroundBeside, IsAMedianToItsEndWhereCarriagewaysOfOneNameSpread) {
  const auto spreading = [](std::int64_t street) {
    return std::vector<StreetAxis>{axis(1, {{0, 0, 0}, {250, 0, 0}, {300, -10, 0}}, along, street),
                                   axis(2, {{300, 26, 0}, {250, 16, 0}, {0, 16, 0}}, along, street),
                                   axis(3, {{300, -10, 0}, {300, 26, 0}}, both, 9)};
  };
  expect_beside(spreading(5), {{1, {median, outer}}, {2, {median, outer}}, {3, {median, outer}}});
  expect_beside(spreading(0), {{1, {median, outer}}, {2, {median, outer}}, {3, {outer, outer}}});
}

// A street parts into its two directions before another one.
std::vector<StreetAxis> parting(double before, double apart) {
  return {axis(1, {{-100, 0, 0}, {0, 0, 0}}, both, 5),
          axis(2, {{0, 0, 0}, {before, -apart / 2, 0}}, along, 5, 4),
          axis(3, {{before, apart / 2, 0}, {0, 0, 0}}, along, 5, 4),
          axis(4, {{before, -apart / 2, 0}, {before, apart / 2, 0}}, both, 6),
          axis(5, {{before, -apart / 2 - 100, 0}, {before, -apart / 2, 0}}, both, 6),
          axis(6, {{before, apart / 2, 0}, {before, apart / 2 + 100, 0}}, both, 6)};
}

TEST(GroundBeside, IsASplitterWhereAStreetPartsBeforeAJunction) {
  expect_beside(parting(30, 16), {{1, {outer, outer}},
                                  {2, {splitter, outer}},
                                  {3, {splitter, outer}},
                                  {4, {splitter, outer}},
                                  {5, {outer, outer}},
                                  {6, {outer, outer}}});
}

TEST(GroundBeside, IsAnIslandWithinASlipLane) {
  expect_beside(
      {axis(1, {{-30, 0, 0}, {0, 0, 0}}, both), axis(2, {{0, 0, 0}, {0, -30, 0}}, both),
       axis(3, {{-30, 0, 0}, {-8, -8, 0}, {0, -30, 0}}, along, 0, 4),
       axis(4, {{-100, 0, 0}, {-30, 0, 0}}, both), axis(5, {{0, -30, 0}, {0, -100, 0}}, both)},
      {{1, {outer, island}},
       {2, {outer, island}},
       {3, {island, outer}},
       {4, {outer, outer}},
       {5, {outer, outer}}});
}

// Its long sides lie beside each other. The short one does not know what is 90 m away.
TEST(GroundBeside, IsAnIslandWithinALongSlipLane) {
  expect_beside(
      {axis(1, {{-90, 0, 0}, {0, 0, 0}}, both), axis(2, {{0, 0, 0}, {0, -14, 0}}, both),
       axis(3, {{-90, 0, 0}, {0, -14, 0}}, along, 0, 4), axis(4, {{-190, 0, 0}, {-90, 0, 0}}, both),
       axis(5, {{0, -14, 0}, {0, -100, 0}}, both)},
      {{1, {outer, island}},
       {2, {outer, outer}},
       {3, {island, outer}},
       {4, {outer, outer}},
       {5, {outer, outer}}});
}

TEST(GroundBeside, IsTheCityWithinABlockOfTwoWayStreets) {
  expect_beside({axis(1, {{0, 0, 0}, {20, 0, 0}}, both), axis(2, {{20, 0, 0}, {0, 20, 0}}, both),
                 axis(3, {{0, 20, 0}, {0, 0, 0}}, both)},
                {{1, {outer, outer}}, {2, {outer, outer}}, {3, {outer, outer}}});
}

// East, north, west, south.
Point unit_out(int quarter) { return turned({1, 0, 0}, quarter * M_PI_2); }

// In four arcs, with a street at each.
std::vector<StreetAxis> ring(double radius) {
  std::vector<StreetAxis> axes;
  for (int quarter = 0; quarter < 4; ++quarter) {
    Line arc;
    for (int i = 0; i <= 8; ++i) {
      const double angle = M_PI_2 * (quarter + i / 8.0);
      arc.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
    }
    axes.push_back(axis(quarter + 1, std::move(arc), along));
    axes.back().on_ring = true;
    const Point out = unit_out(quarter);
    axes.push_back(axis(
        quarter + 11,
        {{out.x * radius, out.y * radius, 0}, {out.x * (radius + 100), out.y * (radius + 100), 0}},
        both));
  }
  return axes;
}

TEST(GroundBeside, IsAnIslandWithinARingOfAnySize) {
  std::map<std::int64_t, std::pair<Beside, Beside>> wanted;
  for (int quarter = 0; quarter < 4; ++quarter) {
    wanted[quarter + 1] = {island, outer};
    wanted[quarter + 11] = {outer, outer};
  }
  for (const double radius : {12.0, 30.0, 90.0}) expect_beside(ring(radius), wanted);
}

// A change of one carriageway changes what lies beside the other.
TEST(GroundBeside, IsToldAnewWhereTheOtherCarriagewayMoved) {
  const std::vector<StreetAxis> apart = pair(40, 5, 5);
  Former former;
  for (const Edge& edge : streets(apart, StreetSettings{}).network.edges)
    former.edges.push_back({edge.axis_id, edge.start_abscissa, edge.end_abscissa, edge.line});
  std::vector<StreetAxis> near = pair(12, 5, 5);
  near[0].changed = false;
  const Streets town = streets(near, StreetSettings{}, {}, former, true);
  ASSERT_EQ(town.network.edges[0].axis_id, 1);
  EXPECT_EQ(town.beside.sides[0], median);
  EXPECT_TRUE(town.affected_edges[0]);
  EXPECT_TRUE(town.edges_with_kerbs[0]);
}

}  // namespace ground_beside_test
}  // namespace streetgen
