// Ends of medians and of traffic islands.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {
namespace nose_test {

// Arcs may lie far from their node.
StreetSettings far_arcs() {
  StreetSettings settings;
  settings.max_arc_distance = 1000;
  return settings;
}

StreetSettings without_bounds() {
  StreetSettings settings = far_arcs();
  settings.follow_length = settings.follow_area = settings.corner_length = settings.corner_area =
      std::numeric_limits<double>::infinity();
  settings.island_area = 0;
  return settings;
}

// From (0, 0) two carriageways 7 m wide part by `angle` and go on 200 m; a street leads on west.
std::vector<StreetAxis> fork(double angle) {
  return {{1, {{0, 0, 0}, {200, 0, 0}}, 0, 7, 7, 6, 3},
          {2, {{0, 0, 0}, {200 * std::cos(angle), 200 * std::sin(angle), 0}}, 0, 7, 7, 6, 3},
          {3, {{-100, 0, 0}, {0, 0, 0}}, 0, 7, 7, 6, 3}};
}

const Corner& between(const Streets& town, std::int64_t axis_a, std::int64_t axis_b) {
  return *std::find_if(town.corners.begin(), town.corners.end(), [&](const Corner& corner) {
    return town.network.edges[corner.edge_a].axis_id == axis_a &&
           town.network.edges[corner.edge_b].axis_id == axis_b;
  });
}

bool is_roadway(const Streets& town, const Point& p) {
  const auto held = [&](const auto& surfaces) {
    return std::any_of(surfaces.begin(), surfaces.end(),
                       [&](const auto& one) { return PreparedSurface(one.surface).holds(p); });
  };
  return held(town.sections) || held(town.intersections);
}

// From the crossing of the kerbs to where a circle touches them: radius / tan(angle / 2); what it
// closes: radius^2 (cot(angle / 2) - (pi - angle) / 2).
TEST(Nose, PavesNoMoreThanItMay) {
  for (const double degrees : {4.0, 8.0, 12.0, 19.0}) {
    const double half = degrees * M_PI / 360;
    const double by_length = 10 * std::tan(half);
    const double by_area = std::sqrt(20 / (1 / std::tan(half) - (M_PI / 2 - half)));
    const Corner corner = between(streets(fork(2 * half), far_arcs()), 1, 2);
    EXPECT_EQ(corner.method, Method::nose) << degrees;
    EXPECT_NEAR(corner.radius, std::max(0.25, std::min(by_length, by_area)), 1e-5) << degrees;
    EXPECT_EQ(corner.radius_wanted, 6);
    const Corner bounded_by_area = [&] {
      StreetSettings settings = far_arcs();
      settings.follow_length = settings.corner_length = 1000;
      return between(streets(fork(2 * half), settings), 1, 2);
    }();
    EXPECT_NEAR(bounded_by_area.radius, std::min(6.0, by_area), 2e-2 * by_area) << degrees;
  }
}

// The wanted arc would lie 109 m from the node.
TEST(Nose, ComesBeforeTheRadiusOfAFarArc) {
  const double half = 5 * M_PI / 180;
  const Corner corner = between(streets(fork(2 * half), {}), 1, 2);
  EXPECT_EQ(corner.method, Method::nose);
  EXPECT_NEAR(corner.radius, 10 * std::tan(half), 1e-5);
  // The kerbs cross 100 m from the node.
  EXPECT_EQ(between(streets(fork(4 * M_PI / 180), {}), 1, 2).method, Method::radius_minimal);
}

TEST(Nose, LeavesTheGroundBehindItFree) {
  const double angle = 8 * M_PI / 180;
  // Half way between both axes, 130 m from the node, they are 18 m apart.
  const Point median{130 * std::cos(angle / 2), 130 * std::sin(angle / 2), 0};
  const Point tip = median * (65 / 130.0);
  EXPECT_FALSE(is_roadway(streets(fork(angle), far_arcs()), tip));
  const Streets filled = streets(fork(angle), without_bounds());
  EXPECT_EQ(between(filled, 1, 2).method, Method::hypothesis);
  EXPECT_EQ(between(filled, 1, 2).radius, 6);
  EXPECT_TRUE(is_roadway(filled, tip));
  EXPECT_FALSE(is_roadway(filled, median * 1.3));
}

TEST(Nose, IsHalfOfTheLeastMedianWhereNothingElseMay) {
  StreetSettings settings = far_arcs();
  settings.follow_area = 0;
  settings.median_width_minimal = 1.5;
  EXPECT_NEAR(between(streets(fork(0.1), settings), 1, 2).radius, 0.75, 1e-9);
}

TEST(Nose, IsNoCornerByHandAndNoneOfTwentyDegreesAndMore) {
  const StreetOverrides typed{{}, {{{0, 0, 0}, 1, 2, 4}}};
  const Corner corner = between(streets(fork(0.1), far_arcs(), typed), 1, 2);
  EXPECT_EQ(corner.method, Method::by_hand);
  EXPECT_EQ(corner.radius, 4);
  EXPECT_EQ(between(streets(fork(20.1 * M_PI / 180), far_arcs()), 1, 2).method,
            Method::radius_reduced);
}

// A triangle of streets 4 m wide about ground that is 6 m by 6 m less the kerbs.
std::vector<StreetAxis> triangle(double size) {
  return {{1, {{0, 0, 0}, {size, 0, 0}}, 0, 4, 4, 6, 3},
          {2, {{size, 0, 0}, {0, size, 0}}, 0, 4, 4, 6, 3},
          {3, {{0, size, 0}, {0, 0, 0}}, 0, 4, 4, 6, 3},
          {4, {{0, 0, 0}, {-60, -60, 0}}, 0, 4, 4, 6, 3},
          {5, {{size, 0, 0}, {size + 60, -20, 0}}, 0, 4, 4, 6, 3},
          {6, {{0, size, 0}, {-20, size + 60, 0}}, 0, 4, 4, 6, 3}};
}

TEST(Island, StaysWhereItsFilletsWouldSwallowIt) {
  // The circle within the kerbs has radius size (1 - 1 / sqrt 2) - 2.
  const double size = 14;
  const double middle = size * (1 - std::sqrt(0.5));
  const Point centre{middle, middle, 0};
  const Streets kept = streets(triangle(size), {});
  EXPECT_FALSE(is_roadway(kept, centre));
  for (const auto& [a, b] : {std::pair(1, 3), std::pair(2, 1), std::pair(3, 2)}) {
    EXPECT_EQ(between(kept, a, b).method, Method::nose);
    EXPECT_EQ(between(kept, a, b).radius, 0.75);
  }
  EXPECT_TRUE(is_roadway(streets(triangle(size), without_bounds()), centre));
}

// The third side of the triangle is a bridge, which shares its nodes with the other two.
TEST(Island, StaysBesideABridge) {
  std::vector<StreetAxis> streets_about = triangle(14);
  for (const std::size_t of_bridge : {1, 4, 5}) streets_about[of_bridge].level = 1;
  const Streets kept = streets(streets_about, {});
  for (const auto& [a, b] : {std::pair(1, 3), std::pair(2, 1), std::pair(3, 2)})
    EXPECT_EQ(between(kept, a, b).method, Method::nose);
}

TEST(Island, OfLargeGroundKeepsItsCorners) {
  for (const auto& corner : streets(triangle(60), {}).corners)
    EXPECT_NE(corner.method, Method::nose);
  StreetSettings settings;
  settings.island_area = 90;  // The face has 98 m2.
  for (const auto& corner : streets(triangle(14), settings).corners)
    EXPECT_NE(corner.method, Method::nose);
}

// Of the triangle between the kerbs, whose circle has a radius of size (1 - 1 / sqrt 2) - 2.
TEST(Island, KeepsMostOfItsGround) {
  for (double size = 12; size <= 42; size += 3) {
    const Streets kept = streets(triangle(size), {});
    const double radius = size * (1 - std::sqrt(0.5)) - 2, leg = radius * (2 + std::sqrt(2));
    int all = 0, left = 0;
    for (int i = 0; i < 60; ++i)
      for (int j = 0; i + j < 59; ++j) {
        ++all;
        left += !is_roadway(kept, {2 + leg * (i + 0.5) / 60, 2 + leg * (j + 0.5) / 60, 0});
      }
    EXPECT_GT(left, 0.85 * all) << size;
  }
}

// Of 8 m: the circle within the kerbs has a radius of 0.34 m.
TEST(Island, WithoutRoomForADiscIsNone) {
  for (const auto& corner : streets(triangle(8), {}).corners)
    EXPECT_NE(corner.method, Method::nose);
}

}  // namespace nose_test
}  // namespace streetgen
