#include "streetgen/streets.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "../../src/core/geos.hpp"
#include "../../src/core/overlap.hpp"
#include "../../src/core/polyline.hpp"
#include "shared_area.hpp"

namespace streetgen {
namespace {

std::vector<StreetAxis> random_town(unsigned seed, int count) {
  std::mt19937_64 random(seed);
  std::vector<Point> places;
  for (int i = 0; i < count / 2; ++i)
    places.push_back({650000 + random() % 4000 / 10.0, 6860000 + random() % 4000 / 10.0, 0});
  std::vector<StreetAxis> axes;
  for (int i = 0; i < count; ++i) {
    const Point &a = places[random() % places.size()], &b = places[random() % places.size()];
    if (distance(a, b) < 1) continue;
    StreetAxis axis;
    axis.axis_id = i + 1;
    axis.line = {a, b};
    axis.width = axis.width_end = 3 + random() % 120 / 10.0;
    axis.radius = random() % 80 / 10.0;
    axis.importance = 1 + random() % 5;
    axes.push_back(axis);
  }
  return axes;
}

// Towns far worse than real ones: streets at any angle, wide, crossing, overlapping.
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
  const Ground ground(town.intersections.front().surface);
  for (double off = 0.05; off < distance(node, town.limits[3].point); off += 0.1)
    EXPECT_TRUE(ground.holds(node + unit(south - node) * off)) << off;
}

// East and north from the origin, 10 m wide; a side street cuts the first 3 m off the one east.
std::vector<StreetAxis> cut_short(double cut, double radius) {
  return {{1, {{0, 0, 0}, {100, 0, 0}}, 0, 10, 10, radius, 3},
          {2, {{0, 0, 0}, {0, 100, 0}}, 0, 10, 10, radius, 3},
          {3, {{cut, 0, 0}, {cut, -80, 0}}, 0, 10, 10, radius, 3}};
}

const Corner* corner_of(const Streets& town, std::int64_t axis_a, std::int64_t axis_b, int node) {
  for (const Corner& corner : town.corners)
    if (corner.node == node && town.network.edges[corner.edge_a].axis_id == axis_a &&
        town.network.edges[corner.edge_b].axis_id == axis_b)
      return &corner;
  return nullptr;
}

bool holds(const MultiPolygon& surface, const Point& p) {
  return std::any_of(surface.begin(), surface.end(),
                     [&](const Polygon& polygon) { return inside(p, polygon); });
}

TEST(Streets, AnAxisTooShortForAnyRadiusIsFollowed) {
  const Streets town = streets(cut_short(3, 5), {});
  const Corner* corner = corner_of(town, 1, 2, 0);
  ASSERT_NE(corner, nullptr);
  EXPECT_EQ(corner->method, Method::followed);
  EXPECT_EQ(corner->radius, 5);
  ASSERT_TRUE(corner->arc.has_value());
  EXPECT_NEAR(distance(*corner->centre, {10, 10, 0}), 0, 1e-9);
  EXPECT_NEAR(distance(corner->arc->start, {10, 5, 0}), 0, 1e-9);
  EXPECT_NEAR(distance(corner->arc->end, {5, 10, 0}), 0, 1e-9);
  // Between the kerbs and the arc, and just behind the arc.
  EXPECT_TRUE(holds(town.intersections[0].surface, {6.2, 6.2, 0}));
  EXPECT_FALSE(holds(town.intersections[0].surface, {6.6, 6.6, 0}));
}

// A link of 3 m between kerbs at 5 m, and the street that goes on from it with a bend.
TEST(Streets, AnAxisIsFollowedWithinABendOfSixtyDegrees) {
  constexpr double degree = M_PI / 180;
  const auto bent = [](double angle) {
    const Point far{3 + 100 * std::cos(angle), 100 * std::sin(angle), 0};
    return streets({{1, {{0, 0, 0}, {3, 0, 0}}, 0, 10, 10, 5, 3},
                    {2, {{0, 0, 0}, {0, 100, 0}}, 0, 10, 10, 5, 3},
                    {3, {{3, 0, 0}, far}, 0, 10, 10, 5, 3},
                    {4, {{3, 0, 0}, {3, -80, 0}}, 0, 10, 10, 5, 3}},
                   {});
  };
  const auto followed_to = [](const Streets& town, const Point& centre) {
    const Corner* corner = corner_of(town, 1, 2, 0);
    EXPECT_EQ(corner->method, Method::followed);
    EXPECT_EQ(corner->radius, 5);
    ASSERT_TRUE(corner->centre.has_value());
    EXPECT_NEAR(distance(*corner->centre, centre), 0, 1e-6);
  };
  EXPECT_EQ(corner_of(bent(-61 * degree), 1, 2, 0)->method, Method::no_arc);
  // Ten metres from both axes: left of the next one, and off the bend, whose outer kerb is round.
  followed_to(bent(35 * degree), {10, (7 * std::sin(35 * degree) + 10) / std::cos(35 * degree), 0});
  followed_to(bent(-50 * degree), {10, std::sqrt(51), 0});
}

TEST(Streets, ATooShortAxisIsReducedUnlessFollowedFirst) {
  // The largest radius on 8 m, with both half widths 5 m and a right angle, is 3 m.
  StreetSettings settings;
  const Streets reduced = streets(cut_short(8, 5), settings);
  settings.short_axis = ShortAxis::follow;
  const Streets followed = streets(cut_short(8, 5), settings);
  const Corner *a = corner_of(reduced, 1, 2, 0), *b = corner_of(followed, 1, 2, 0);
  EXPECT_EQ(a->method, Method::radius_reduced);
  EXPECT_NEAR(a->radius, 3, 1e-6);
  EXPECT_EQ(b->method, Method::followed);
  EXPECT_EQ(b->radius, 5);
  EXPECT_NEAR(distance(*b->centre, {10, 10, 0}), 0, 1e-9);
}

// Two straight axes of 112 m, 4.5 degrees apart: their kerbs part within the last metres.
TEST(Streets, AFarCornerTakesNoMoreThanFits) {
  constexpr double angle = 4.506 * M_PI / 180, size = 112, half_a = 7, half_b = 1.75;
  const double fits =
      (size * std::sin(angle) - half_a - half_b * std::cos(angle)) / (1 + std::cos(angle));
  ASSERT_GT(fits, 0.01);
  ASSERT_LT(fits, StreetSettings{}.radius_minimal);
  const Streets town = streets(
      {{1, {{0, 0, 0}, {size, 0, 0}}, 0, 2 * half_a, 2 * half_a, 6, 3},
       {2, {{0, 0, 0}, {size * std::cos(angle), size * std::sin(angle), 0}}, 0, 3.5, 3.5, 6, 3},
       {3, {{0, 0, 0}, {-100, 0, 0}}, 0, 2 * half_a, 2 * half_a, 6, 3}},
      {});
  const Corner* corner = corner_of(town, 1, 2, 0);
  ASSERT_NE(corner, nullptr);
  EXPECT_EQ(corner->method, Method::radius_minimal);
  EXPECT_NEAR(corner->radius, fits, 1e-6);
}

TEST(Streets, NoAxisIsFollowedBeyondReach) {
  StreetSettings settings;
  settings.reach = 2;
  EXPECT_EQ(corner_of(streets(cut_short(3, 5), settings), 1, 2, 0)->method, Method::no_arc);
}

// The first 3 m of the axis east, 10 m wide, and what goes on from them.
std::vector<StreetAxis> going_on(double width, int level) {
  return {{1, {{0, 0, 0}, {3, 0, 0}}, 0, 10, 10, 5, 3},
          {2, {{0, 0, 0}, {0, 100, 0}}, 0, 10, 10, 5, 3},
          {3, {{3, 0, 0}, {100, 0, 0}}, level, width, width, 5, 3}};
}

// The kerb at `foot`, with the roadway below it.
void lies_on_a_kerb(const Streets& town, const Point& foot) {
  const auto roadway = [&](const Point& p) {
    const auto held = [&](const auto& surfaces) {
      return std::any_of(surfaces.begin(), surfaces.end(),
                         [&](const auto& one) { return holds(one.surface, p); });
    };
    return held(town.sections) || held(town.intersections);
  };
  EXPECT_TRUE(roadway(foot - Point{0, 0.01, 0})) << foot.x;
  EXPECT_FALSE(roadway(foot + Point{0.3, 0.1, 0})) << foot.x;
}

TEST(Streets, AnAxisIsFollowedOntoAnotherLevel) {
  const Streets town = streets(going_on(10, 1), {});
  const Corner* corner = corner_of(town, 1, 2, 0);
  ASSERT_EQ(corner->method, Method::followed);
  EXPECT_EQ(corner->radius, 5);
  EXPECT_NEAR(distance(*corner->centre, {10, 10, 0}), 0, 1e-9);
  EXPECT_TRUE(holds(town.intersections[0].surface, {6.2, 6.2, 0}));
}

TEST(Streets, AnAxisIsFollowedIntoAnotherWidth) {
  for (const double width : {12.0, 8.0}) {
    const Streets town = streets(going_on(width, 0), {});
    const Corner* corner = corner_of(town, 1, 2, 0);
    ASSERT_EQ(corner->method, Method::followed) << width;
    EXPECT_EQ(corner->radius, 5);
    EXPECT_NEAR(distance(*corner->centre, {10, width / 2 + 5, 0}), 0, 1e-9);
    lies_on_a_kerb(town, corner->arc->start);
    double shared = 0;
    for (const Section& section : town.sections)
      for (const Intersection& intersection : town.intersections)
        shared += shared_area(section.surface, intersection.surface);
    EXPECT_LE(shared, 1e-6) << width;
  }
}

// A link that leaves a road, and the loop it goes on to, which comes back to the road.
TEST(Streets, NoAxisIsFollowedToWhereItComesBack) {
  Line loop{{22, 2, 0}};
  double heading = std::atan2(2, 22);
  for (int step = 0; step < 22; ++step) {
    heading += M_PI / 12;
    loop.push_back(loop.back() + Point{std::cos(heading), std::sin(heading), 0} * (25 * M_PI / 12));
  }
  const Streets town = streets({{1, {{-100, 0, 0}, {0, 0, 0}}, 0, 7, 7, 6, 2},
                                {2, {{0, 0, 0}, {20, -2, 0}}, 0, 7, 7, 6, 2},
                                {3, {{20, -2, 0}, {120, -12, 0}}, 0, 7, 7, 6, 2},
                                {4, {{0, 0, 0}, {22, 2, 0}}, 0, 7, 7, 6, 2},
                                {5, loop, 0, 7, 7, 6, 2}},
                               {});
  for (const Intersection& intersection : town.intersections)
    EXPECT_FALSE(holds(intersection.surface, {20, 27, 0})) << intersection.node;
}

TEST(Streets, NoAxisIsFollowedIntoAnotherWidthPastAStreetBetween) {
  for (const double side : {1.0, -1.0}) {
    std::vector<StreetAxis> axes = going_on(12, 0);
    axes.push_back({4, {{3, 0, 0}, {33, side * 80, 0}}, 0, 10, 10, 5, 3});
    const Method method = corner_of(streets(axes, {}), 1, 2, 0)->method;
    EXPECT_EQ(method, side > 0 ? Method::no_arc : Method::followed) << side;
  }
}

// On the kerb that widens from 5 to 6 m, from where the limits of the first axis cross.
TEST(Streets, AnAxisIsFollowedAlongAKerbThatWidens) {
  std::vector<StreetAxis> axes = going_on(12, 0);
  axes[2].transition_start = Transition{TransitionKind::left, 60};
  const Streets town = streets(axes, {});
  const Corner* corner = corner_of(town, 1, 2, 0);
  ASSERT_EQ(corner->method, Method::followed);
  const double from = 3 - 1.2 * 3 / 4.2, slope = 1 / (33 - from);
  const double rise = 5 * std::sqrt(1 + slope * slope);
  EXPECT_NEAR(distance(*corner->centre, {10, 5 + (10 - from) * slope + rise, 0}), 0, 1e-9);
  lies_on_a_kerb(town, corner->arc->start);
}

// The kerb beside it steps at the node and is straight on from there.
TEST(Streets, AnAxisIsFollowedAlongAKerbThatSteps) {
  std::vector<StreetAxis> axes = going_on(12, 0);
  axes[2].transition_start = Transition{TransitionKind::right, 60};
  const Streets town = streets(axes, {});
  const Corner* corner = corner_of(town, 1, 2, 0);
  ASSERT_EQ(corner->method, Method::followed);
  EXPECT_NEAR(distance(*corner->centre, {10, 11, 0}), 0, 1e-9);
  lies_on_a_kerb(town, corner->arc->start);
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
  return !within(1e-6) && (holds(surface, p) || within(1e-4));
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

// The same, of one that meets the first beside its end, which makes its line longer.
TEST(Streets, AnEndThatMovesFarOffMovesNoBorder) {
  const std::vector<StreetAxis> two = {
      {2, {{0, 0, 0}, {140, 25, 0}, {318.73, 88.9, 0}}, 0, 8, 8, 4, 3},
      {3, {{320, 90, 0}, {230, 80, 0}}, 0, 7, 7, 4, 3}};
  std::vector<StreetAxis> three = two;
  three.push_back({1, {{-50, 60, 0}, {-0.3, 0.2, 0}}, 0, 7, 7, 4, 3});
  const Streets before = streets(two, {}), after = streets(three, {});
  ASSERT_EQ(after.network.edges[1].line.front().x, -0.3);
  const MultiPolygon &first = before.sections[0].surface, &second = after.sections[2].surface;
  ASSERT_EQ(after.network.edges[after.sections[2].edge].axis_id, 3);
  EXPECT_GT(before.sections[0].contested_area, 10);
  EXPECT_LT(shared_area(first, second), 2e-5);
  EXPECT_NEAR(area(second), area(before.sections[1].surface), 2e-5);
}

FormerLimit former_of(const SectionLimit& limit) {
  return {limit.wanted_abscissa, limit.abscissa, limit.border_line};
}

Former former_of(const Streets& before) {
  Former former;
  for (const Section& section : before.sections)
    former.edges.push_back({before.network.edges[section.edge].axis_id,
                            before.network.edges[section.edge].start_abscissa,
                            before.network.edges[section.edge].end_abscissa,
                            before.network.edges[section.edge].line,
                            former_of(before.limits[2 * section.edge]),
                            former_of(before.limits[2 * section.edge + 1]),
                            {section.surface, section.contested_area > 0}});
  for (const Intersection& intersection : before.intersections)
    former.nodes.push_back({before.network.nodes[intersection.node].point,
                            {intersection.surface, intersection.contested_area > 0}});
  return former;
}

// Areas of surfaces, by edge and by node.
struct Areas {
  explicit Areas(const Streets& town)
      : sections(town.network.edges.size()), intersections(town.network.nodes.size()) {
    for (const Section& section : town.sections) sections[section.edge] = area(section.surface);
    for (const Intersection& crossing : town.intersections)
      intersections[crossing.node] = area(crossing.surface);
  }
  std::vector<double> sections, intersections;
};

// Surfaces about one axis, built from what may matter to them, against those of the whole town.
TEST(Streets, ComeOutTheSameFromTheirVicinityAlone) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    std::vector<StreetAxis> axes = random_town(seed, 24);
    const Streets whole = streets(axes, {});
    const Areas areas(whole);
    std::size_t compared = 0;
    for (std::int64_t edited = 1; edited <= 6; ++edited) {
      for (StreetAxis& axis : axes) axis.changed = axis.axis_id == edited;
      const Streets part = streets(axes, {}, {}, former_of(whole));
      for (const Section& section : part.sections) {
        EXPECT_EQ(area(section.surface), areas.sections[section.edge])
            << "seed " << seed << ", axis " << edited << ", edge " << section.edge;
        ++compared;
      }
      for (const Intersection& intersection : part.intersections) {
        EXPECT_EQ(area(intersection.surface), areas.intersections[intersection.node])
            << "seed " << seed << ", axis " << edited << ", node " << intersection.node;
        ++compared;
      }
    }
    EXPECT_GE(compared, 12u);
  }
}

// A wider axis takes ground: what is asked comes out as in the whole town, and nothing else is
// another there.
TEST(Streets, AWiderAxisAsksForAllThatItChanges) {
  std::size_t asked = 0, left = 0;
  StreetSettings settings;
  settings.crossing = Crossing::split;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    std::vector<StreetAxis> axes = random_town(seed, 40);
    for (StreetAxis& axis : axes) axis.width = axis.width_end = axis.width / 3;
    const Streets before = streets(axes, settings);
    const Areas was(before);
    for (std::int64_t edited = 1; edited <= 10; ++edited) {
      std::vector<StreetAxis> wider = axes;
      for (StreetAxis& axis : wider) {
        axis.changed = axis.axis_id == edited;
        if (axis.changed) axis.width = axis.width_end = 1.1 * axis.width;
      }
      const Areas is(streets(wider, settings));
      const Streets part = streets(wider, settings, {}, former_of(before));
      const Areas told(part);
      const auto compare = [&](const std::vector<bool>& out, const std::vector<double>& of_part,
                               const std::vector<double>& old, const std::vector<double>& now,
                               const char* what) {
        for (std::size_t i = 0; i < out.size(); ++i) {
          EXPECT_EQ(out[i] ? of_part[i] : old[i], now[i])
              << what << ' ' << i << (out[i] ? ", asked" : "") << ", seed " << seed << ", axis "
              << edited;
          ++(out[i] ? asked : left);
        }
      };
      compare(part.asked_edges, told.sections, was.sections, is.sections, "edge");
      compare(part.asked_nodes, told.intersections, was.intersections, is.intersections, "node");
    }
  }
  EXPECT_GT(asked, 500u);
  EXPECT_GT(left, asked);
}

// The wide street lay on the ground about a node of two others, and goes.
TEST(Streets, AnIntersectionThatLostGroundGetsItBack) {
  std::vector<StreetAxis> axes = {
      {8, {{122, 100, 0}, {190, 102, 0}}, 0, 5.5, 5.5, 4, 5},
      {14, {{190, 102, 0}, {191, 150, 0}}, 0, 5, 5, 4, 6},
      {15, {{147.71, 110.08, 0}, {196.63, 101.82, 0}}, 0, 15.68, 15.68, 4, 3}};
  const auto at_bend = [](const Streets& town) -> const Intersection& {
    return *std::find_if(
        town.intersections.begin(), town.intersections.end(),
        [&](const Intersection& i) { return town.network.nodes[i.node].point.x == 190; });
  };
  const Streets before = streets(axes, {});
  EXPECT_GT(at_bend(before).contested_area, 5);
  axes[2].line = {{147.71, 110.08, 0}, {248.08, 151.78, 0}};
  axes[0].changed = axes[1].changed = false;
  EXPECT_NEAR(area(at_bend(streets(axes, {}, {}, former_of(before))).surface),
              area(at_bend(before).surface) + at_bend(before).contested_area, 1e-6);
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
  EXPECT_TRUE(holds(tee->surface, {1e-3, 1e-3, 0}));
}

// Two streets leave a hole between them, which goes to one of them until a street of another level
// that ends on a third one covers it.
TEST(Streets, AHoleThatIsCoveredGoesBack) {
  std::vector<StreetAxis> axes = {
      {237,
       {{55.7933130867, 88.698831765, 0},
        {62.5851039334, 90.413623994, 0},
        {70.2127205366, 97.681852341, 0}},
       0,
       6,
       6,
       3,
       5},
      {427,
       {{66.3257846195, 102.493926154, 0},
        {63.5836806569, 99.880003191, 0},
        {59.1934797047, 95.711095422, 0},
        {55.7933130867, 88.698831765, 0}},
       0,
       6,
       6,
       3,
       5},
      {442,
       {{70.2127205366, 97.681852341, 0}, {66.3257846195, 102.493926154, 0}},
       0,
       9,
       9,
       6.25,
       2}};
  const Streets before = streets(axes, {});
  for (StreetAxis& axis : axes) axis.changed = false;
  axes.push_back({543,
                  {{60.8727205367, 93.851852341, 0},
                   {108.3257846195, 133.723926155, 0},
                   {66.2157846196, 102.273926155, 0}},
                  1,
                  14.6,
                  14.6,
                  3,
                  4});
  const Areas was(before), told(streets(axes, {}, {}, former_of(before))), is(streets(axes, {}));
  EXPECT_NE(was.sections[1], is.sections[1]);
  EXPECT_EQ(told.sections[1], is.sections[1]);
}

// A limit by hand leaves a street no section: another gets ground back that this kept from it,
// though what it was left lies more than two metres off.
TEST(Streets, GroundComesBackToASurfaceThatWasLeftNoneBesideIt) {
  std::vector<StreetAxis> axes = {
      {4, {{-4.6519, 33.832, 0}, {54.5541, 41.4442, 0}}, -1, 5.96, 5.96, 6.25, 2},
      {5, {{-4.6519, 33.832, 0}, {33.4091, 94.3067, 0}}, 0, 10.48, 10.48, 6.25, 2},
      {7, {{54.5541, 41.4442, 0}, {33.4091, 94.3067, 0}}, 0, 19.19, 19.19, 3, 5},
      {8, {{-4.6519, 33.832, 0}, {73.5846, 90.5006, 0}}, 0, 6, 6, 14.53, 5},
      {9,
       {{50.748, 1.2687, 0}, {49.02685, 84.11365, 0}, {73.5846, 90.5006, 0}},
       0,
       10.68,
       10.68,
       3,
       5}};
  StreetOverrides by_hand;
  by_hand.limits.push_back({7, 51.37, true});
  const Streets before = streets(axes, {});
  const Areas was(before), is(streets(axes, {}, by_hand));
  for (StreetAxis& axis : axes) axis.changed = axis.axis_id == 7;
  const Areas told(streets(axes, {}, by_hand, former_of(before)));
  EXPECT_GT(is.sections[3], was.sections[3] + 30);
  EXPECT_EQ(told.sections[3], is.sections[3]);
}

// An axis that is said to have changed, and did not: of its neighbours, whose surfaces stay what
// they were, none comes out.
TEST(Streets, LeaveOutWhatStaysWhatItWas) {
  std::size_t out = 0, met = 0;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    std::vector<StreetAxis> axes = random_town(seed, 40);
    const Streets whole = streets(axes, {});
    const auto& edges = whole.network.edges;
    for (std::int64_t edited = 1; edited <= 10; ++edited) {
      for (StreetAxis& axis : axes) axis.changed = axis.axis_id == edited;
      const Streets part = streets(axes, {}, {}, former_of(whole));
      std::vector<bool> at(whole.network.nodes.size());
      for (const Edge& edge : edges)
        if (edge.axis_id == edited) at[edge.from_node] = at[edge.to_node] = true;
      for (std::size_t e = 0; e < edges.size(); ++e) {
        EXPECT_EQ(part.asked_edges[e], edges[e].axis_id == edited)
            << "seed " << seed << ", axis " << edited << ", edge " << e;
        out += part.asked_edges[e];
        met += at[edges[e].from_node] || at[edges[e].to_node];
      }
    }
  }
  EXPECT_GT(met, out);
}

// The end of a street moves, and with it the next one, which ends where one meets it that is not
// written.
TEST(Streets, TellAlongWhichAxesAChangeLeadsOn) {
  std::vector<StreetAxis> axes = {{7, {{0, 0, 0}, {100, 0, 0}}, 0, 6, 6, 4, 5},
                                  {8, {{100, 0, 0}, {200, 0, 0}}, 0, 6, 6, 4, 5},
                                  {9, {{200, 0, 0}, {300, 50, 0}}, 0, 6, 6, 4, 5}};
  Former former = former_of(streets(axes, {}));
  former.edges.pop_back();
  axes[0].line.back().y = 0.3;
  axes[1].changed = axes[2].changed = false;
  axes[2].outer = true;
  EXPECT_EQ(streets(axes, {}, {}, former).leading_on, (std::vector<bool>{false, true, false}));
  former.onwards = false;
  try {
    streets(axes, {}, {}, former);
    FAIL();
  } catch (const LeadsOn& leads_on) {
    EXPECT_EQ(leads_on.axes(), std::vector<std::int64_t>{8});
  }
}

}  // namespace
}  // namespace streetgen
