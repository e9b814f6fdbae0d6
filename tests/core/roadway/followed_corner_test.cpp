// Corners at axes too short for their arc: they follow the street that goes on, or take less.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "shared_area.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {
namespace followed_corner_test {

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
  EXPECT_TRUE(PreparedSurface(town.intersections[0].surface).holds({6.2, 6.2, 0}));
  EXPECT_FALSE(PreparedSurface(town.intersections[0].surface).holds({6.6, 6.6, 0}));
}

// However far, as the paper has it.
StreetSettings far_followed() {
  StreetSettings settings;
  settings.corner_length = settings.corner_area = settings.follow_length = settings.follow_area =
      std::numeric_limits<double>::infinity();
  return settings;
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
                   far_followed());
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

TEST(Streets, ABoundOfTheGroundMakesNoAxisTooShort) {
  StreetSettings settings;
  settings.short_axis = ShortAxis::follow;
  // At a right angle an arc closes radius^2 (1 - pi / 4) square metres.
  settings.corner_area = 4;
  const double bounded = std::sqrt(4 / (1 - M_PI_4));
  const Streets short_axis = streets(cut_short(8, 5), settings),
                long_axis = streets(cut_short(60, 5), settings);
  const Corner *a = corner_of(short_axis, 1, 2, 0), *b = corner_of(long_axis, 1, 2, 0);
  EXPECT_EQ(a->method, Method::followed);
  EXPECT_NEAR(a->radius, bounded, 0.02);  // its arc has chords when its ground is measured
  EXPECT_EQ(b->method, Method::radius_reduced);
  EXPECT_NEAR(b->radius, bounded, 1e-6);
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
                         [&](const auto& one) { return PreparedSurface(one.surface).holds(p); });
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
  EXPECT_TRUE(PreparedSurface(town.intersections[0].surface).holds({6.2, 6.2, 0}));
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
    EXPECT_FALSE(PreparedSurface(intersection.surface).holds({20, 27, 0})) << intersection.node;
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

}  // namespace followed_corner_test
}  // namespace streetgen
