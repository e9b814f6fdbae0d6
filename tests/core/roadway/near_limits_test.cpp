// Limits where kerbs part far from their node.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "shared_area.hpp"
#include "streetgen/lane.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {
namespace near_limits_test {

constexpr double degree = M_PI / 180;

StreetSettings unbounded() {
  StreetSettings settings;
  settings.limit_distance = std::numeric_limits<double>::infinity();
  return settings;
}

// From (0, 0) a street east and a link that leaves it to the left by `angle`; a street west.
std::vector<StreetAxis> fork(double angle, double width, double link_width) {
  return {{1, {{0, 0, 0}, {300, 0, 0}}, 0, width, width, 6, 2},
          {2,
           {{0, 0, 0}, {300 * std::cos(angle), 300 * std::sin(angle), 0}},
           0,
           link_width,
           link_width,
           6,
           3},
          {3, {{-100, 0, 0}, {0, 0, 0}}, 0, width, width, 6, 2}};
}

// Metres from the node at (0, 0) to the limit of an axis there.
double limit_of(const Streets& town, std::int64_t axis) {
  for (const SectionLimit& limit : town.limits) {
    const Edge& edge = town.network.edges[limit.edge];
    const bool at_fork =
        distance(planar(town.network.nodes[limit.at_start ? edge.from_node : edge.to_node].point),
                 {0, 0, 0}) < 1e-6;
    if (edge.axis_id == axis && at_fork)
      return limit.at_start ? limit.wanted_abscissa : length(edge.line) - limit.wanted_abscissa;
  }
  return -1;
}

std::vector<const MultiPolygon*> surfaces_of(const Streets& town) {
  std::vector<const MultiPolygon*> surfaces;
  for (const Section& section : town.sections) surfaces.push_back(&section.surface);
  for (const Intersection& intersection : town.intersections)
    surfaces.push_back(&intersection.surface);
  return surfaces;
}

double ground_of(const Streets& town) {
  double ground = 0;
  for (const MultiPolygon* surface : surfaces_of(town)) ground += area(*surface);
  return ground;
}

const Corner& between(const Streets& town, std::int64_t axis_a, std::int64_t axis_b) {
  return *std::find_if(town.corners.begin(), town.corners.end(), [&](const Corner& corner) {
    return town.network.edges[corner.edge_a].axis_id == axis_a &&
           town.network.edges[corner.edge_b].axis_id == axis_b;
  });
}

// Kerbs of 7 m and 4 m cross 5.5 m / sin(angle), or more, from the node.
TEST(NearLimits, SectionsBeginBeforeKerbsPartAndTile) {
  for (const double degrees : {4.0, 8.0, 12.0})
    for (const double link : {4.0, 7.0}) {
      const std::vector<StreetAxis> axes = fork(degrees * degree, 7, link);
      const Streets town = streets(axes, {}), far = streets(axes, unbounded());
      EXPECT_GT(limit_of(far, 1), 25) << degrees;
      for (const std::int64_t axis : {1, 2}) {
        EXPECT_GT(limit_of(town, axis), 15) << degrees;
        EXPECT_LT(limit_of(town, axis), 25 + 1e-9) << degrees;
      }
      // The corner is the same, and the roadway, but where the kerb of the link tapers.
      EXPECT_EQ(between(town, 1, 2).radius, between(far, 1, 2).radius);
      EXPECT_NEAR(ground_of(town), ground_of(far), link < 7 ? 0.2 : 1e-3) << degrees << ' ' << link;
      const auto surfaces = surfaces_of(town);
      for (std::size_t i = 0; i < surfaces.size(); ++i) {
        EXPECT_LE(surfaces[i]->size(), 1u);
        for (std::size_t j = 0; j < i; ++j)
          EXPECT_EQ(shared_area(*surfaces[i], *surfaces[j]), 0) << degrees << ' ' << link;
      }
    }
}

// The section of an axis.
const MultiPolygon& section_of(const Streets& town, std::int64_t axis) {
  return std::find_if(town.sections.begin(), town.sections.end(),
                      [&](const Section& section) {
                        return town.network.edges[section.edge].axis_id == axis;
                      })
      ->surface;
}

bool has_vertex(const MultiPolygon& surface, const Point& place) {
  const Ring& ring = surface.front().front();
  return std::any_of(ring.begin(), ring.end(), [&](const Point& p) { return same(p, place); });
}

// The same coordinates on both sides, also where the link bends: no seam is left between.
TEST(NearLimits, SectionsShareTheLineThatPartsThem) {
  for (const double link : {4.0, 7.0}) {
    std::vector<StreetAxis> axes = fork(8 * degree, 7, link);
    axes[1].line = {{0, 0, 0}, {20, 2, 0}, {34, 4, 0}, {60, 9, 0}, {200, 60, 0}};
    const Streets town = streets(axes, {});
    const MultiPolygon &street = section_of(town, 1), &side = section_of(town, 2);
    ASSERT_EQ(street.size(), 1u);
    int shared = 0;
    for (const Point& p : street.front().front()) shared += has_vertex(side, p);
    // The crossing of the border lines, the bends up to that of the kerbs, and the arc's middle.
    EXPECT_GE(shared, 4) << link;
    EXPECT_EQ(shared_area(street, side), 0) << link;
    for (const Section& section : town.sections)
      EXPECT_EQ(section.method, Method::hypothesis) << link;
  }
}

TEST(NearLimits, LanesKeepToTheGroundOfTheirSection) {
  for (const double link : {4.0, 7.0}) {
    const Streets town = streets(fork(8 * degree, 7, link), {});
    const AxisLanes two_way{std::vector<LaneWish>(1), std::vector<LaneWish>(1)};
    const Lanes made = lanes(town, {{1, two_way}, {2, two_way}, {3, two_way}}, {}, {});
    for (const Lane& a : made.lanes)
      for (const Lane& b : made.lanes)
        if (a.edge < b.edge) EXPECT_LT(shared_area(a.surface, b.surface), 1e-6) << link;
  }
}

// A fork by 8 degrees, whose kerbs cross 50 m away, and whose link meets two streets.
std::vector<StreetAxis> with_short_link(double link_length) {
  std::vector<StreetAxis> axes = fork(8 * degree, 7, 7);
  const Point end{link_length * std::cos(8 * degree), link_length * std::sin(8 * degree), 0};
  axes[1].line = {{0, 0, 0}, end};
  axes.push_back({4, {end, end + Point{0, 100, 0}}, 0, 7, 7, 6, 3});
  axes.push_back({5, {end, end + Point{100, 60, 0}}, 0, 7, 7, 6, 3});
  return axes;
}

void expect_tiled(const Streets& town) {
  const auto surfaces = surfaces_of(town);
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_EQ(shared_area(*surfaces[i], *surfaces[j]), 0);
}

// Sections end before the kerbs part where the link is short: one intersection holds all up to
// there.
TEST(NearLimits, AreThoseOfTheCornerWhereASectionEndsBeforeTheKerbsPart) {
  const std::vector<StreetAxis> axes = with_short_link(52);
  EXPECT_EQ(limit_of(streets(axes, {}), 1), limit_of(streets(axes, unbounded()), 1));
}

// A smaller arc ends before the section does.
TEST(NearLimits, ArcsFitTheSectionsOnWhichTheyEnd) {
  const std::vector<StreetAxis> axes = with_short_link(66);
  const Streets town = streets(axes, {}), far = streets(axes, unbounded());
  EXPECT_GT(limit_of(far, 1), 50);
  for (const std::int64_t axis : {1, 2}) EXPECT_LT(limit_of(town, axis), 25 + 1e-9);
  const Corner &corner = between(town, 1, 2), &wide = between(far, 1, 2);
  EXPECT_LT(corner.radius, wide.radius);
  EXPECT_GE(corner.radius, 0.25);
  const Point end = axes[1].line.back();
  EXPECT_LT(distance(end, corner.arc->end) - 3.5, distance(end, wide.arc->end));
  EXPECT_GT(distance(end, corner.arc->end), distance(end, wide.arc->end));
  expect_tiled(town);
}

// A fork with a street that leaves on the right by 28 degrees: that corner holds 29 m of the
// street.
std::vector<StreetAxis> beside_a_corner(double angle) {
  std::vector<StreetAxis> axes = fork(angle, 7, 7);
  axes.push_back({4,
                  {{0, 0, 0}, {200 * std::cos(28 * degree), -200 * std::sin(28 * degree), 0}},
                  0,
                  7,
                  7,
                  6,
                  3});
  return axes;
}

TEST(NearLimits, FollowThatOfTheirNeighbour) {
  const Streets town = streets(beside_a_corner(4 * degree), {});
  EXPECT_GT(limit_of(town, 1), 27);
  EXPECT_LT(limit_of(town, 1), 30);
  EXPECT_NEAR(limit_of(town, 2), limit_of(town, 1), 0.1);
  expect_tiled(town);
}

// Kerbs cross 26.6 m away, before the limit that another corner wants: a smaller arc is near.
TEST(NearLimits, ArcsAreSmallWhereNothingPartsTheSections) {
  const std::vector<StreetAxis> axes = beside_a_corner(15 * degree);
  const Streets town = streets(axes, {}), far = streets(axes, unbounded());
  EXPECT_GT(limit_of(far, 2), 32);
  for (const std::int64_t axis : {1, 2}) EXPECT_LT(limit_of(town, axis), 30);
  EXPECT_LT(between(town, 1, 2).radius, between(far, 1, 2).radius);
  EXPECT_GE(between(town, 1, 2).radius, 0.25);
  EXPECT_EQ(between(town, 1, 2).method, Method::nose);
  expect_tiled(town);
}

TEST(NearLimits, EachSectionHasTheGroundNearerToItsAxis) {
  const double angle = 8 * degree;
  const Streets town = streets(fork(angle, 7, 7), {});
  const auto held = [&](std::int64_t axis, const Point& p) {
    return std::any_of(town.sections.begin(), town.sections.end(), [&](const Section& section) {
      return town.network.edges[section.edge].axis_id == axis &&
             PreparedSurface(section.surface).holds(p);
    });
  };
  for (double at = 27; at < 48; at += 1.7)
    for (const double share : {0.1, 0.4, 0.6, 0.9}) {
      const Point p{at * std::cos(share * angle), at * std::sin(share * angle), 0};
      EXPECT_EQ(held(1, p), share < 0.5) << at << ' ' << share;
      EXPECT_EQ(held(2, p), share > 0.5) << at << ' ' << share;
    }
}

TEST(NearLimits, AreThoseOfTheCornerWhereItIsNearOrByHand) {
  const std::vector<StreetAxis> near = fork(40 * degree, 7, 7);
  EXPECT_EQ(limit_of(streets(near, {}), 1), limit_of(streets(near, unbounded()), 1));
  const StreetOverrides typed{{}, {{{0, 0, 0}, 1, 2, 4}}};
  EXPECT_GT(limit_of(streets(fork(12 * degree, 7, 7), {}, typed), 1), 25);
}

// Streets of two levels share no ground.
TEST(NearLimits, AreFarBetweenLevels) {
  std::vector<StreetAxis> axes = fork(8 * degree, 7, 7);
  axes[1].level = 1;
  EXPECT_GT(limit_of(streets(axes, {}), 1), 25);
}

// Who comes along the link waits where the kerbs part, beside the through street.
TEST(NearLimits, LinesLieWhereTheKerbsPart) {
  const Streets town = streets(fork(12 * degree, 7, 7), {});
  const AxisLanes two_way{std::vector<LaneWish>(1), std::vector<LaneWish>(1)};
  const Lanes made = lanes(town, {{1, two_way}, {2, two_way}, {3, two_way}}, {}, {});
  int lines = 0;
  for (const Marking& marking : made.markings) {
    if (marking.kind == MarkingKind::arrow) continue;
    ++lines;
    for (const Point& p : marking.line) EXPECT_GT(p.y, 3.5 - 1e-6);
  }
  EXPECT_GT(lines, 0);
}

}  // namespace near_limits_test
}  // namespace streetgen
