// Corners reach no farther from the crossing of their kerbs than they may, and lie where the kerbs
// cross first on the way out from the node.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "streetgen/corner.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {
namespace corner_bound_test {

StreetAxis street(std::int64_t axis_id, Line line, double width = 6) {
  return {axis_id, std::move(line), 0, width, width, 8, 3};
}

StreetSettings as_the_paper() {
  StreetSettings settings;
  settings.corner_length = settings.corner_area = settings.follow_length = settings.follow_area =
      settings.limit_distance = std::numeric_limits<double>::infinity();
  settings.max_arc_distance = 1000;
  settings.island_area = 0;
  return settings;
}

double radius_between(const Streets& town, std::int64_t axis_a, std::int64_t axis_b) {
  for (const Corner& corner : town.corners)
    if (town.network.edges[corner.edge_a].axis_id == axis_a &&
        town.network.edges[corner.edge_b].axis_id == axis_b)
      return corner.radius;
  return -1;
}

double signed_areas(const MultiPolygon& surface) {
  double area = 0;
  for (const Polygon& polygon : surface)
    for (const Ring& ring : polygon) area += signed_area(ring);
  return area;
}

bool is_roadway(const Streets& town, const Point& p) {
  const auto held = [&](const auto& surfaces) {
    return std::any_of(surfaces.begin(), surfaces.end(),
                       [&](const auto& one) { return PreparedSurface(one.surface).holds(p); });
  };
  return held(town.sections) || held(town.intersections);
}

Streets fork(double degrees, const StreetSettings& settings) {
  const double angle = degrees * M_PI / 180;
  return streets({street(1, {{0, 0, 0}, {200, 0, 0}}),
                  street(2, {{0, 0, 0}, {200 * std::cos(angle), 200 * std::sin(angle), 0}}),
                  street(3, {{-100, 0, 0}, {0, 0, 0}})},
                 settings);
}

// An arc touches kerbs radius / tan(angle / 2) beyond their crossing, and leaves
// radius^2 (1 / tan(angle / 2) - (pi - angle) / 2) between it and them.
TEST(CornerBound, HoldsTheLengthAndTheGroundOfASharpCorner) {
  for (const double degrees : {25.0, 30.0, 45.0, 60.0, 90.0, 120.0}) {
    const double angle = degrees * M_PI / 180, along = 1 / std::tan(angle / 2);
    const double by_area = std::sqrt(20 / (along - (M_PI - angle) / 2)), by_length = 15 / along;
    StreetSettings settings, by_length_alone;
    settings.corner_area = 20;
    EXPECT_NEAR(radius_between(fork(degrees, settings), 1, 2), std::min({8.0, by_area, by_length}),
                1e-6)
        << degrees;
    by_length_alone.corner_area = std::numeric_limits<double>::infinity();
    EXPECT_NEAR(radius_between(fork(degrees, by_length_alone), 1, 2), std::min(8.0, by_length),
                1e-6)
        << degrees;
    EXPECT_EQ(radius_between(fork(degrees, as_the_paper()), 1, 2), 8) << degrees;
  }
}

// The bend lies before the arc, so that the crossing of the kerbs is looked for.
TEST(CornerBound, HoldsWhereTheStreetsBend) {
  const double angle = 25 * M_PI / 180;
  const Point bend{13 * std::cos(angle), 13 * std::sin(angle), 0};
  const Streets town = streets({street(1, {{0, 0, 0}, {200, 0, 0}}),
                                street(2, {{0, 0, 0}, bend, {bend.x + 150, bend.y + 60, 0}}),
                                street(3, {{-100, 0, 0}, {0, 0, 0}})},
                               {});
  const Streets unbound = streets({street(1, {{0, 0, 0}, {200, 0, 0}}),
                                   street(2, {{0, 0, 0}, bend, {bend.x + 150, bend.y + 60, 0}}),
                                   street(3, {{-100, 0, 0}, {0, 0, 0}})},
                                  as_the_paper());
  const auto crossing = corner_arc(town.network.edges[0].line, town.network.edges[1].line, 6, 6, 0);
  ASSERT_TRUE(crossing);
  EXPECT_LE(town.limits[0].abscissa - crossing->abscissa_a, 15);
  EXPECT_LE(town.limits[2].abscissa - crossing->abscissa_b, 15);
  EXPECT_GT(unbound.limits[0].abscissa - crossing->abscissa_a, 15);
}

// A road that comes back to its own start: its legs leave 16 degrees apart, and no circle of the
// wanted radius has room between them before the wide end.
const Line pear{{0, 0, 0}, {-6, 55, 0}, {-20, 130, 0}, {45, 140, 0}, {13, 52, 0}, {0, 0, 0}};

TEST(CornerBound, LeavesTheInsideOfALoop) {
  const Streets town = streets({street(1, pear), street(2, {{0, 0, 0}, {10, -60, 0}})}, {});
  EXPECT_FALSE(is_roadway(town, {5, 110, 0}));
  EXPECT_FALSE(is_roadway(town, {3, 60, 0}));
  ASSERT_EQ(town.network.edges[0].axis_id, 1);
  const double size = length(pear);
  EXPECT_LT(town.limits[0].abscissa, 50);
  EXPECT_GT(town.limits[1].abscissa, size - 50);
  EXPECT_GT(signed_areas(town.sections[0].surface), 6 * (size - 100));
}

// The circle between both legs touches them within half of the loop, not where a leg becomes the
// other one.
TEST(CornerArc, LiesWithinHalfOfALoop) {
  const Line back = reversed(pear);
  const double half = length(pear) / 2;
  for (const double radius : {0., 1., 2., 3.}) {
    const auto corner = corner_arc(back, pear, 6, 6, radius);
    ASSERT_TRUE(corner) << radius;
    EXPECT_LT(corner->abscissa_a, half) << radius;
    EXPECT_LT(corner->abscissa_b, half) << radius;
  }
}

// Two roads between the same two junctions, 9 m apart at most.
TEST(CornerBound, LeavesTheGroundOfALens) {
  const Streets town =
      streets({street(1, {{-100, 0, 0}, {0, 0, 0}}), street(2, {{0, 0, 0}, {60, 0, 0}}),
               street(3, {{0, 0, 0}, {12, 10, 0}, {48, 10, 0}, {60, 0, 0}}),
               street(4, {{60, 0, 0}, {160, 0, 0}})},
              {});
  EXPECT_FALSE(is_roadway(town, {30, 5, 0}));
  for (const Section& section : town.sections) EXPECT_FALSE(section.surface.empty());
  for (const double x : {18.0, 42.0}) EXPECT_FALSE(is_roadway(town, {x, 5, 0})) << x;
}

}  // namespace corner_bound_test
}  // namespace streetgen
