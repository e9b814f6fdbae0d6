// Two corners on one kerb that is too short for the arcs that both want.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {
namespace shared_kerb_test {

StreetAxis street(std::int64_t axis_id, Line line, double radius, double width = 6) {
  return {axis_id, std::move(line), 0, width, width, radius, 3};
}

double radius_between(const Streets& town, std::int64_t axis_a, std::int64_t axis_b) {
  for (const Corner& corner : town.corners)
    if (town.network.edges[corner.edge_a].axis_id == axis_a &&
        town.network.edges[corner.edge_b].axis_id == axis_b)
      return corner.radius;
  return -1;
}

bool is_roadway(const Streets& town, const Point& p) {
  const auto held = [&](const auto& surfaces) {
    return std::any_of(surfaces.begin(), surfaces.end(),
                       [&](const auto& one) { return PreparedSurface(one.surface).holds(p); });
  };
  return held(town.sections) || held(town.intersections);
}

// Ground 5 cm within the circle of each arc between these axes, at its middle.
void expect_ground_behind_arcs(const Streets& town, std::int64_t last_axis = 99) {
  const auto& edges = town.network.edges;
  for (const Corner& corner : town.corners) {
    if (!corner.arc || edges[corner.edge_a].axis_id > last_axis ||
        edges[corner.edge_b].axis_id > last_axis)
      continue;
    const Point in = *corner.centre - corner.arc->middle;
    EXPECT_FALSE(is_roadway(town, corner.arc->middle + in * (0.05 / corner.radius)))
        << corner.radius << " at " << corner.arc->middle.x << " " << corner.arc->middle.y;
  }
}

// Side streets so far apart, 6 m wide as the street that they leave.
Streets side_streets(double apart, double radius, double other, const StreetSettings& settings) {
  return streets({street(1, {{-60, 0, 0}, {0, 0, 0}}, 20), street(2, {{0, 0, 0}, {apart, 0, 0}}, 20),
                  street(3, {{apart, 0, 0}, {apart + 60, 0, 0}}, 20),
                  street(4, {{0, 0, 0}, {0, 50, 0}}, radius),
                  street(5, {{apart, 0, 0}, {apart, 50, 0}}, other)},
                 settings);
}

TEST(SharedKerb, GivesEachCornerHalf) {
  const Streets town = side_streets(20, 8, 8, {});
  EXPECT_NEAR(radius_between(town, 2, 4), 7, 1e-6);
  EXPECT_NEAR(radius_between(town, 5, 2), 7, 1e-6);
  EXPECT_EQ(radius_between(town, 4, 1), 8);
  expect_ground_behind_arcs(town);
}

TEST(SharedKerb, GivesOneWhatTheOtherLeaves) {
  const Streets town = side_streets(20, 3, 12, {});
  EXPECT_EQ(radius_between(town, 2, 4), 3);
  EXPECT_NEAR(radius_between(town, 5, 2), 11, 1e-6);
  expect_ground_behind_arcs(town);
}

TEST(SharedKerb, HasRoomForBoth) {
  const Streets town = side_streets(22.1, 8, 8, {});
  EXPECT_EQ(radius_between(town, 2, 4), 8);
  EXPECT_EQ(radius_between(town, 5, 2), 8);
}

// Both streets lie upon each other.
TEST(SharedKerb, HasNoArcWhereNoGroundIsBetween) {
  const Streets town = side_streets(5.5, 8, 8, {});
  EXPECT_EQ(radius_between(town, 2, 4), 0);
  EXPECT_EQ(radius_between(town, 5, 2), 0);
  EXPECT_EQ(radius_between(town, 4, 1), 8);
  expect_ground_behind_arcs(town);
}

TEST(SharedKerb, IsNotSharedWhereArcsHaveNoBound) {
  StreetSettings settings;
  settings.corner_length = std::numeric_limits<double>::infinity();
  const Streets town = side_streets(20, 8, 8, settings);
  EXPECT_EQ(radius_between(town, 2, 4), 8);
  EXPECT_EQ(radius_between(town, 5, 2), 8);
}

TEST(SharedKerb, LeavesACornerByHand) {
  const StreetOverrides typed{{}, {{{0, 0, 0}, 2, 4, 8}}};
  const Streets town = streets(
      {street(1, {{-60, 0, 0}, {0, 0, 0}}, 20), street(2, {{0, 0, 0}, {20, 0, 0}}, 20),
       street(3, {{20, 0, 0}, {80, 0, 0}}, 20), street(4, {{0, 0, 0}, {0, 50, 0}}, 8),
       street(5, {{20, 0, 0}, {20, 50, 0}}, 8)},
      {}, typed);
  EXPECT_EQ(radius_between(town, 2, 4), 8);
  EXPECT_NEAR(radius_between(town, 5, 2), 7, 1e-6);
}

// On the sides of a triangle, and on its outside.
std::vector<StreetAxis> triangle(double size, double lean, double turn) {
  const auto at = [&](double x, double y) {
    return Point{x * std::cos(turn) - y * std::sin(turn), x * std::sin(turn) + y * std::cos(turn),
                 0};
  };
  const Point a = at(0, 0), b = at(size, 0), c = at(lean, size);
  return {street(1, {a, b}, 8),
          street(2, {b, c}, 8),
          street(3, {c, a}, 8),
          street(4, {a, at(-60, -60)}, 8),
          street(5, {b, at(size + 60, -20)}, 8),
          street(6, {c, at(lean - 20, size + 60)}, 8)};
}

TEST(SharedKerb, LeavesNoArcInTheRoadwayOfATriangle) {
  StreetSettings settings;
  settings.island_area = 0;
  for (const double turn : {0.0, 0.7, 2.2})
    for (double size = 20; size <= 60; size += 4)
      for (const double lean : {0.0, size / 3, size})
        expect_ground_behind_arcs(streets(triangle(size, lean, turn), settings), 3);
}

// The ground between the kerbs has 0.3 m2.
TEST(SharedKerb, LeavesNoHole) {
  const double size = (3 + std::sqrt(0.6) / (2 + std::sqrt(2))) / (1 - std::sqrt(0.5));
  const double middle = size * (1 - std::sqrt(0.5));
  EXPECT_TRUE(is_roadway(streets(triangle(size, 0, 0), {}), {middle, middle, 0}));
}

}  // namespace shared_kerb_test
}  // namespace streetgen
