// Kerbs of a street that goes on with another width, at nodes of any degree.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {
namespace taper_test {

// A street goes on east from 6 m to 10 m wide, where a side street leaves north.
Streets widening(const StreetSettings& settings) {
  return streets({{1, {{-100, 0, 0}, {0, 0, 0}}, 0, 6, 6, 6, 3},
                  {2, {{0, 0, 0}, {100, 0, 0}}, 0, 10, 10, 6, 3},
                  {3, {{0, 0, 0}, {0, 80, 0}}, 0, 6, 6, 6, 3}},
                 settings);
}

bool on_roadway(const Streets& town, const Point& p) {
  const auto held = [&](const auto& surfaces) {
    return std::any_of(surfaces.begin(), surfaces.end(),
                       [&](const auto& one) { return PreparedSurface(one.surface).holds(p); });
  };
  return held(town.sections) || held(town.intersections);
}

// How far south the roadway reaches at an abscissa.
double kerb_at(const Streets& town, double x) {
  double inside = 1, outside = 12;
  while (outside - inside > 1e-6) {
    const double middle = (inside + outside) / 2;
    (on_roadway(town, {x, -middle, 0}) ? inside : outside) = middle;
  }
  return inside;
}

TEST(Taper, HasNoStepWhereASideStreetLeaves) {
  const Streets town = widening({});
  // 10 m along the street for each metre aside, half of that on each edge.
  const double limit_west = 100 - town.limits[1].abscissa, limit_east = town.limits[2].abscissa;
  ASSERT_GT(limit_west, 5);
  ASSERT_GT(limit_east, 5);
  const double west = std::max(limit_west, 10.0), east = std::max(limit_east, 10.0);
  for (double x = -west; x <= east; x += 0.37)
    EXPECT_NEAR(kerb_at(town, x), 3 + 2 * (x + west) / (west + east), 2e-6) << x;
  EXPECT_NEAR(kerb_at(town, -west - 0.1), 3, 1e-5);
  EXPECT_NEAR(kerb_at(town, east + 0.1), 5, 1e-5);
  EXPECT_EQ(town.intersections[0].method, Method::hypothesis);
  EXPECT_EQ(std::count_if(town.corners.begin(), town.corners.end(),
                          [](const Corner& c) { return c.method == Method::transition; }),
            1);
}

// Two narrow streets leave a wide one side by side: the kerbs between them cross 50 m away, and the
// outer ones are their own long before.
TEST(Taper, EndsBeforeALimitThatLiesFarAway) {
  StreetSettings settings;
  settings.limit_distance = std::numeric_limits<double>::infinity();
  for (const bool turned : {false, true}) {
    Line wide{{-100, 0, 0}, {0, 0, 0}};
    if (turned) std::reverse(wide.begin(), wide.end());
    const Point north = unit(Point{150, 6, 0}), south = unit(Point{150, -6, 0});
    const Streets town = streets({{1, wide, 0, 12, 12, 6, 3},
                                  {2, {{0, 0, 0}, north * 150}, 0, 4, 4, 6, 3},
                                  {3, {{0, 0, 0}, south * 150}, 0, 4, 4, 6, 3}},
                                 settings);
    ASSERT_GT(town.limits[2].abscissa, 40);
    for (const double side : {+1.0, -1.0})
      for (double at = 0; at < 80; at += 1.7) {
        const Point along = side > 0 ? north : south, aside = left_normal(along) * side;
        // 40 m for 4 m aside, half of it on each street.
        const double half = std::max(2.0, 4 - at / 10);
        EXPECT_TRUE(on_roadway(town, along * at + aside * (half - 0.1))) << at;
        EXPECT_FALSE(on_roadway(town, along * at + aside * (half + 0.1))) << at;
      }
  }
}

// How far the roadway reaches from y = 0 to one side.
double kerb_aside(const Streets& town, double x, int side) {
  double inside = 0.1, outside = 12;
  while (outside - inside > 1e-6) {
    const double middle = (inside + outside) / 2;
    (on_roadway(town, {x, side * middle, 0}) ? inside : outside) = middle;
  }
  return inside;
}

// A street parts into two carriageways that touch or lie within each other by a little; one of them
// bends more by what rounding leaves.
TEST(Taper, IsAsLongOnBothSidesOfAFork) {
  for (const double aside : {3.3, 3.49, 3.5, 4.0})
    for (const double more : {-5e-4, 0.0, 5e-4}) {
      std::vector<StreetAxis> axes{
          {1, {{0, 0, 0}, {100, 0, 0}}, 0, 14, 14, 6, 3},
          {2, {{100, 0, 0}, {120, -aside, 0}, {260, -aside, 0}}, 0, 7, 7, 6, 3},
          {3, {{260, aside, 0}, {120, aside + more, 0}, {100, 0, 0}}, 0, 7, 7, 6, 3}};
      axes[1].leads_backward = axes[2].leads_backward = false;
      const Streets town = streets(axes, {});
      double before = 7;
      for (double x = 60.013; x <= 200; x += 0.5) {
        const double south = kerb_aside(town, x, -1), north = kerb_aside(town, x, +1);
        EXPECT_NEAR(south, north, 5e-3) << aside << ' ' << more << ' ' << x;
        EXPECT_NEAR(south, before, 0.3) << aside << ' ' << more << ' ' << x;
        before = south;
      }
    }
}

// Branches half as wide leave a street on both sides, straight or as a curve: its kerbs go on to
// where those of the branches come out, and do not dip at the node.
TEST(Taper, GoesStraightOnWhereABranchBendsOut) {
  for (const double slope : {0.08, 0.15, 0.3})
    for (const bool turned : {false, true}) {
      Line stem{{-100, 0, 0}, {0, 0, 0}};
      if (turned) std::reverse(stem.begin(), stem.end());
      const Point north = unit(Point{1, slope, 0}), south = unit(Point{1, -slope, 0});
      const Streets town = streets({{1, stem, 0, 7, 7, 6, 3},
                                    {2, {{0, 0, 0}, north * 120}, 0, 3.5, 3.5, 6, 3},
                                    {3, {{0, 0, 0}, south * 120}, 0, 3.5, 3.5, 6, 3}},
                                   {});
      for (double x = -20.013; x < 1.6 / slope; x += 0.5)
        for (const int side : {-1, +1})
          EXPECT_NEAR(kerb_aside(town, x, side),
                      std::max(3.5, slope * x + 1.75 * std::hypot(1, slope)), 0.02)
              << slope << ' ' << x;
    }
}

// A street goes on straight where a narrower one leaves at a small angle.
TEST(Taper, KeepsTheKerbOfTheStreetThatGoesOn) {
  for (const double slope : {0.07, 0.1, 0.2}) {
    const Point away = unit(Point{1, slope, 0});
    const Streets town = streets({{1, {{-100, 0, 0}, {0, 0, 0}}, 0, 10, 10, 6, 3},
                                  {2, {{0, 0, 0}, {60, -2, 0}, {120, -4, 0}}, 0, 10, 10, 6, 3},
                                  {3, {{0, 0, 0}, away * 120}, 0, 7, 7, 6, 3}},
                                 {});
    for (double x = -20.013; x < 25; x += 0.5)
      EXPECT_NEAR(kerb_aside(town, x, +1), std::max(5.0, slope * x + 3.5 * std::hypot(1, slope)),
                  0.02)
          << slope << ' ' << x;
  }
}

// The kerb tapers on the outside of a bend, and another street leaves so slowly on the other side
// that no one ring goes about the node.
TEST(Taper, HasNoToothOnTheOutsideOfABend) {
  StreetSettings settings;
  settings.limit_distance = std::numeric_limits<double>::infinity();
  int by_union = 0;
  for (int degrees = 2; degrees <= 14; degrees += 2) {
    const Point along{std::cos(degrees * M_PI / 180), -std::sin(degrees * M_PI / 180), 0};
    const Streets town = streets({{1, {{-90, 0, 0}, {0, 0, 0}}, 0, 18, 18, 6, 3},
                                  {2, {{0, 0, 0}, along * 90}, 0, 7, 7, 6, 3},
                                  {3, {{0, 0, 0}, {-21, -4, 0}, {-60, -25, 0}}, 0, 7, 7, 6, 3}},
                                 settings);
    const Intersection& node = town.intersections[0];
    if (node.method == Method::robust_fallback) ++by_union;
    // 55 m for 5.5 m aside.
    const Line street{{-90, 0, 0}, {0, 0, 0}, along * 90};
    for (const Point& p : node.surface.front().front())
      if (p.y > 0 && std::abs(p.x) < 3)
        EXPECT_NEAR(distance_to_line(p, street), 6.25, 0.35) << degrees << ' ' << p.x;
  }
  EXPECT_GT(by_union, 0);
}

TEST(Taper, IsNoneWhereTheLengthIsANumber) {
  StreetSettings settings;
  settings.transition.length = 5;
  for (const Corner& corner : widening(settings).corners)
    EXPECT_NE(corner.method, Method::transition);
}

TEST(Taper, IsLongerWhereStreetsAreFast) {
  const auto length_at = [](double speed) {
    const auto axis = [&](int id, double from, double to, double width) {
      StreetAxis axis{id, {{from, 0, 0}, {to, 0, 0}}, 0, width, width, 6, 3};
      axis.speed = speed;
      return axis;
    };
    const Streets town = streets({axis(1, -200, 0, 6), axis(2, 0, 200, 8)}, {});
    return town.limits[2].abscissa + 200 - town.limits[1].abscissa;
  };
  // Each kerb moves 1 m sideways.
  EXPECT_NEAR(length_at(50), 10, 1e-9);
  EXPECT_NEAR(length_at(70), 20, 1e-9);
  EXPECT_NEAR(length_at(90), 30, 1e-9);
  EXPECT_NEAR(length_at(130), 40, 1e-9);
}

// A part of a street 9 m wide again, 6 m wide: its kerbs are those of the wider, and no side of the
// street is told from the other.
TEST(Taper, IsNoneOfAStreetDrawnAgainWithinAWiderOne) {
  for (const double mirror : {1.0, -1.0}) {
    const auto place = [&](double along) { return Point{along, 0.3 * along * mirror, 0}; };
    const Streets town = streets({{1, {place(0), place(60), place(200)}, 0, 9, 9, 6, 3},
                                  {2, {place(150), place(40)}, 0, 6, 6, 6, 3}},
                                 {});
    EXPECT_TRUE(std::none_of(town.corners.begin(), town.corners.end(),
                             [](const Corner& c) { return c.method == Method::transition; }));
    double ground = 0, between = 0;
    for (const Section& section : town.sections) ground += area(section.surface);
    for (const Intersection& node : town.intersections) between += area(node.surface);
    EXPECT_NEAR(ground + between, 9 * 200 * std::hypot(1, 0.3), 1e-4) << mirror;
    // No longer than the nodes need.
    EXPECT_LT(between, 3 * 9) << mirror;
  }
}

}  // namespace taper_test
}  // namespace streetgen
