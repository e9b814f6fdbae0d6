#include "streetgen/streets.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "geometry/geos.hpp"
#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "random_town.hpp"
#include "shared_area.hpp"

namespace streetgen {
namespace streets_test {

TEST(Streets, SurfacesAreValidAndTileWhateverTheTown) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    StreetSettings settings;
    settings.crossing = Crossing::split;
    const Streets town = streets(random_town(seed, 40), settings);
    Geos geos;
    std::vector<const MultiPolygon*> surfaces;
    double roadway = 0, shared = 0;
    for (const Section& section : town.sections) surfaces.push_back(&section.surface);
    for (const Intersection& intersection : town.intersections)
      surfaces.push_back(&intersection.surface);
    for (const MultiPolygon* surface : surfaces) {
      EXPECT_TRUE(geos.valid(geos.surface(*surface).get())) << "seed " << seed;
      roadway += area(*surface);
    }
    for (std::size_t i = 0; i < surfaces.size(); ++i)
      for (std::size_t j = i + 1; j < surfaces.size(); ++j)
        shared += shared_area(*surfaces[i], *surfaces[j]);
    EXPECT_LE(shared, 1e-6 * roadway) << "seed " << seed;
  }
}

double shared_area(const Streets& town) {
  std::vector<std::pair<int, const MultiPolygon*>> surfaces;
  for (const Section& section : town.sections)
    surfaces.emplace_back(town.network.edges[section.edge].level, &section.surface);
  for (const Intersection& intersection : town.intersections)
    surfaces.emplace_back(intersection.level, &intersection.surface);
  double shared = 0;
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    for (std::size_t j = i + 1; j < surfaces.size(); ++j)
      if (surfaces[i].first == surfaces[j].first)
        shared += shared_area(*surfaces[i].second, *surfaces[j].second);
  return shared;
}

// Borders that nearly coincide: taken off one by one, the ground was left to both, 225 m2 and 66
// m2.
TEST(Streets, GroundBesideBordersThatNearlyCoincideHasOneOwner) {
  const double wide = 10.993672855600714;
  StreetSettings round;
  round.round_dead_ends = true;
  EXPECT_LT(
      shared_area(streets(
          {{2, {{36, 86}, {214.3, 65.91}}, 0, wide, wide, 3, 3},
           {4, {{82, 81}, {36, 86}}, 0, 1, 1, 3, 3},
           {6,
            {{142.38357599710352, 79.16513232751592}, {177.2293222011422, 60.659288880281494}},
            0,
            wide,
            wide,
            3,
            1},
           {7, {{41.76, 143.142}, {178, 61}}, 0, 1.8030671612973683, 1.8030671612973683, 3, 3}},
          round)),
      1e-5);
  StreetSettings split;
  split.crossing = Crossing::split;
  const double wider = 41.338173381264561, least = 13.651281196484593;
  EXPECT_LT(
      shared_area(streets(
          {{1,
            {{-999999944.85069001, 500000159.57113314},
             {-1000000001.5608757, 500000116.22200084},
             {-999999935.66433299, 500000088.7841056}},
            0,
            wider,
            wider,
            3,
            3},
           {3,
            {{-999999936, 500000089}, {-1000000002, 500000116}},
            0,
            least,
            least,
            0.31104963467886076,
            3},
           {5,
            {{-999999950.80217254, 500000095.08717465}, {-999999985.1527493, 500000109.39001185}},
            0,
            wider,
            wider,
            3,
            3}},
          split)),
      1e-3);
}

// A wide street of another level that forks at a bridge's end: the flat ends of the fork lie on it.
TEST(Streets, AnIntersectionTilesWithItsSectionsOfEveryLevel) {
  const std::vector<StreetAxis> fork = {{1, {{0, 0, 0}, {-80, 0, 0}}, 1, 12, 12, 3, 3},
                                        {2, {{0, 0, 0}, {80, 0, 0}}, 0, 6, 6, 3, 3},
                                        {3, {{0, 0, 0}, {80, 40, 0}}, 0, 6, 6, 3, 3}};
  const Streets town = streets(fork, {});
  ASSERT_EQ(town.intersections.size(), 1u);
  const Intersection& intersection = town.intersections.front();
  for (const Section& section : town.sections)
    EXPECT_LE(shared_area(section.surface, intersection.surface), 1e-6)
        << "axis " << town.network.edges[section.edge].axis_id;
}

// The short one's kerbs end beyond that of the wide one.
TEST(Streets, AnIntersectionHoldsAWideAxisBesideAShortOne) {
  const Point node{650528.74, 6860111.34, 0}, south{650529.51, 6860092.41, 0};
  const StreetAxis shorter{1, {{650530, 6860110}, node}, 0, 4.75, 13.96, 6.25, 3};
  const StreetAxis wide{2, {south, node}, 0, 20.83, 20.83, 8, 1};
  const Streets town = streets({shorter, wide}, {});
  ASSERT_EQ(town.intersections.size(), 1u);
  const PreparedSurface ground(town.intersections.front().surface);
  for (double off = 0.05; off < distance(node, town.limits[3].point); off += 0.1)
    EXPECT_TRUE(ground.holds(node + unit(south - node) * off)) << off;
}

// Two streets bowed away from each other between the same nodes: nothing overlaps, and the lens
// between their kerbs holds a circle of 0.3 m at most.
TEST(Streets, AnIslandOfATinyBlockIsRoadway) {
  constexpr double half = 2, inner = 0.3;
  const double bow = 10 * (half + inner) / std::sqrt(100 - (half + inner) * (half + inner));
  const Streets town = streets({{1, {{0, 0, 0}, {10, bow, 0}, {20, 0, 0}}, 0, 4, 4, 3, 3},
                                {2, {{0, 0, 0}, {10, -bow, 0}, {20, 0, 0}}, 0, 4, 4, 3, 3},
                                {3, {{-50, 0, 0}, {0, 0, 0}}, 0, 4, 4, 3, 3},
                                {4, {{20, 0, 0}, {70, 0, 0}}, 0, 4, 4, 3, 3}},
                               {});
  std::vector<MultiPolygon> surfaces;
  for (const Section& section : town.sections) surfaces.push_back(section.surface);
  for (const Intersection& intersection : town.intersections)
    surfaces.push_back(intersection.surface);
  Geos geos;
  const MultiPolygon roadway = geos.polygons(geos.unite(surfaces).get());
  ASSERT_EQ(roadway.size(), 1u);
  EXPECT_EQ(roadway[0].size(), 1u);
}

// Bent to either side: the corner inside the bend, or both where it is slight, would take an arc.
TEST(Streets, AChangeOfWidthHasNoCornerArc) {
  for (const double y : {-30.0, -5.0, 0.0, 5.0, 30.0}) {
    const Streets town = streets({{1, {{-80, 0, 0}, {0, 0, 0}}, 0, 10, 10, 5, 3},
                                  {2, {{0, 0, 0}, {80, y, 0}}, 0, 6, 6, 5, 3}},
                                 {});
    ASSERT_EQ(town.corners.size(), 2u) << y;
    for (const Corner& corner : town.corners) {
      EXPECT_EQ(corner.method, Method::transition) << y;
      EXPECT_EQ(corner.radius_wanted, 5) << y;
      EXPECT_EQ(corner.radius, 0) << y;
      EXPECT_FALSE(corner.centre.has_value()) << y;
      EXPECT_FALSE(corner.arc.has_value()) << y;
    }
    ASSERT_EQ(town.intersections.size(), 1u) << y;
    EXPECT_EQ(town.intersections.front().method, Method::transition) << y;
  }
}

// Bent streets of many widths that meet at any angle, each with another that goes on from it.
std::vector<StreetAxis> random_junction(std::mt19937_64& random) {
  const auto between = [&](double from, double to) {
    return from + (to - from) * (random() % 1000001) / 1e6;
  };
  const Point node{between(650000, 651000), between(6860000, 6861000), 0};
  std::vector<StreetAxis> axes;
  const int arms = 2 + random() % 4;
  const double width = between(4, 12), radius = random() % 3 ? between(1, 8) : 0;
  const bool uniform = random() % 2;
  double angle = between(0, 7);
  for (int i = 0; i < arms; ++i) {
    angle += between(0.7, 2) * 6.3 / (1.4 * arms);
    StreetAxis axis;
    axis.line.assign(1, node);
    double direction = angle;
    for (int k = 0; k < 6; ++k) {
      const Point along{std::cos(direction), std::sin(direction), 0};
      axis.line.push_back(axis.line.back() + along * between(2, k < 3 ? 12 : 40));
      if (random() % 2) direction += between(-0.5, 0.5);
      if (k != 2 && k != 5) continue;
      axis.axis_id = axes.size() + 1;
      axis.width = uniform ? width : between(4, 12);
      axis.width_end = uniform || random() % 3 ? axis.width : between(4, 12);
      axis.radius = radius;
      axes.push_back(axis);
      if (random() % 2) std::reverse(axes.back().line.begin(), axes.back().line.end());
      axis.line.erase(axis.line.begin(), axis.line.end() - 1);
    }
  }
  return axes;
}

// A vertex, to the last bit, wherever the boundary comes near. An end may lie deep inside, and in a
// bend that is all but straight a border line sticks out by what its sections overlap.
bool ends_at(const MultiPolygon& surface, const Point& p) {
  const auto within = [&](double reach) {
    for (const Polygon& polygon : surface)
      for (const Ring& ring : polygon)
        if (comes_within(p, ring, reach)) return true;
    return false;
  };
  for (const Polygon& polygon : surface)
    for (const Ring& ring : polygon)
      for (const Point& q : ring)
        if (q.x == p.x && q.y == p.y) return true;
  return !within(1e-6) && (PreparedSurface(surface).holds(p) || within(1e-4));
}

TEST(Streets, NeighboursShareTheirBorderLineVertexForVertex) {
  std::mt19937_64 random(17);
  std::map<Method, int> seen;
  for (int round = 0; round < 300; ++round) {
    StreetSettings settings;
    settings.transition.kind = static_cast<TransitionKind>(random() % 3);
    const Streets town = streets(random_junction(random), settings);
    std::map<int, const Intersection*> at_node;
    for (const Intersection& intersection : town.intersections)
      at_node[intersection.node] = &intersection;
    const auto check = [&](const auto& row, const Line& border) {
      if (row.surface.empty() || row.contested_area > 0) return;
      for (const Point& p : border)
        EXPECT_TRUE(ends_at(row.surface, p)) << round << " " << method_name(row.method);
      ++seen[row.method];
    };
    for (const SectionLimit& limit : town.limits) {
      const Edge& edge = town.network.edges[limit.edge];
      check(town.sections[limit.edge], limit.border_line);
      const auto neighbour = at_node.find(limit.at_start ? edge.from_node : edge.to_node);
      if (neighbour != at_node.end()) check(*neighbour->second, limit.border_line);
    }
  }
  for (const Method method : {Method::hypothesis, Method::transition, Method::robust_fallback})
    EXPECT_GT(seen[method], 50) << method_name(method);
}

// Two axes that leave a node nearly side by side: one street in a hairpin, or two streets that
// fork.
TEST(Streets, OnlyOneStreetIsRoundBehindAHairpin) {
  for (const double width : {10.5, 3.5}) {
    const Streets town = streets({{1, {{0, 0, 0}, {80, 0, 0}}, 0, 10.5, 10.5, 6, 3},
                                  {2, {{0, 0, 0}, {80, 20, 0}}, 0, width, width, 6, 3}},
                                 {});
    ASSERT_EQ(town.intersections.size(), 1u);
    const Point second = unit({80, 20, 0});
    double behind = 0;  // both flat ends
    for (const Point& p : town.intersections.front().surface.front().front())
      behind = std::max(behind, std::min(-p.x, -dot(p, second)));
    if (width == 10.5)
      EXPECT_GT(behind, 5);
    else
      EXPECT_NEAR(behind, 0, 1e-6);
  }
}

TEST(Streets, LimitsAreInOrderAndTwoPerEdge) {
  const Streets town = streets(random_town(21, 60), {});
  ASSERT_EQ(town.limits.size(), 2 * town.network.edges.size());
  for (std::size_t e = 0; e < town.network.edges.size(); ++e)
    EXPECT_LE(town.limits[2 * e].abscissa, town.limits[2 * e + 1].abscissa + 1e-9);
}

TEST(Streets, AnAxisShorterThanAMillimetreHasFiniteLimits) {
  StreetSettings settings;
  settings.tolerance = 1e-10;
  const Streets town = streets({{1, {{0, 0, 0}, {1e-9, 0, 0}}, 0, 7, 7, 5, 3}}, settings);
  ASSERT_EQ(town.limits.size(), 2u);
  for (const SectionLimit& limit : town.limits) EXPECT_TRUE(std::isfinite(limit.abscissa));
}

TEST(Streets, DoesNotDependOnTheOrderOfTheAxes) {
  std::vector<StreetAxis> axes = random_town(5, 50);
  const Streets first = streets(axes, {});
  std::reverse(axes.begin(), axes.end());
  const Streets second = streets(axes, {});
  ASSERT_EQ(first.sections.size(), second.sections.size());
  for (std::size_t i = 0; i < first.sections.size(); ++i)
    EXPECT_EQ(area(first.sections[i].surface), area(second.sections[i].surface));
}

// Its first street shares ground with the second; the third cuts the first, far from there.
TEST(Streets, ACutFarOffMovesNoBorder) {
  const std::vector<StreetAxis> two = {{1, {{0, 0, 0}, {318.73, 88.9, 0}}, 0, 8, 8, 4, 3},
                                       {2, {{320, 90, 0}, {230, 80, 0}}, 0, 7, 7, 4, 3}};
  std::vector<StreetAxis> three = two;
  three.push_back({3, {{140, 6, 0}, {138, 104, 0}}, 0, 7, 7, 4, 3});
  StreetSettings split;
  split.crossing = Crossing::split;
  const Streets whole = streets(two, split), cut = streets(three, split);
  const MultiPolygon &first = whole.sections[0].surface, &second = cut.sections[2].surface;
  ASSERT_EQ(cut.network.edges[cut.sections[2].edge].axis_id, 2);
  EXPECT_GT(whole.sections[0].contested_area, 10);
  // Ground is shared out on a grid of a tenth of a micrometre, here along 200 m of border.
  EXPECT_LT(shared_area(first, second), 2e-5);
  EXPECT_NEAR(area(second), area(whole.sections[1].surface), 2e-5);
}

// The same, of one that meets the first beside its end: the node in the middle makes its line
// longer.
TEST(Streets, AnEndThatMovesFarOffMovesNoBorder) {
  const std::vector<StreetAxis> two = {
      {2, {{0, 0, 0}, {140, 25, 0}, {318.73, 88.9, 0}}, 0, 8, 8, 4, 3},
      {3, {{320, 90, 0}, {230, 80, 0}}, 0, 7, 7, 4, 3}};
  std::vector<StreetAxis> three = two;
  three.push_back({1, {{-50, 60, 0}, {-0.3, 0.2, 0}}, 0, 7, 7, 4, 3});
  const Streets before = streets(two, {}), after = streets(three, {});
  ASSERT_EQ(after.network.edges[1].line.front().x, -0.15);
  const MultiPolygon &first = before.sections[0].surface, &second = after.sections[2].surface;
  ASSERT_EQ(after.network.edges[after.sections[2].edge].axis_id, 3);
  EXPECT_GT(before.sections[0].contested_area, 10);
  EXPECT_LT(shared_area(first, second), 2e-5);
  EXPECT_NEAR(area(second), area(before.sections[1].surface), 2e-5);
}

// The T between two narrow streets, which a wide and more important one crosses beside it, lies
// all on that one's roadway.
TEST(Streets, AnIntersectionKeepsItsNode) {
  const Streets town = streets({{1, {{-30, 9.75, 0}, {35, -9.75, 0}}, 0, 20, 20, 4, 1},
                                {2, {{-30, 0, 0}, {0, 0, 0}}, 0, 4, 4, 1, 5},
                                {3, {{0, 0, 0}, {30, 0, 0}}, 0, 4, 4, 1, 5},
                                {4, {{0, 0, 0}, {0, -30, 0}}, 0, 4, 4, 1, 5}},
                               {});
  const auto tee = std::find_if(
      town.intersections.begin(), town.intersections.end(),
      [&](const Intersection& i) { return distance(town.network.nodes[i.node].point, {}) == 0; });
  ASSERT_NE(tee, town.intersections.end());
  EXPECT_GT(tee->contested_area, 0);
  EXPECT_TRUE(PreparedSurface(tee->surface).holds({1e-3, 1e-3, 0}));
}

}  // namespace streets_test
}  // namespace streetgen
