// The middle of two dual carriageways that cross.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/prepared_surface.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {
namespace crossing_middle_test {

bool is_roadway(const Streets& town, const Point& p) {
  const auto held = [&](const auto& surfaces) {
    return std::any_of(surfaces.begin(), surfaces.end(),
                       [&](const auto& one) { return PreparedSurface(one.surface).holds(p); });
  };
  return held(town.sections) || held(town.intersections);
}

Point turned(const Point& p, double angle) {
  return {p.x * std::cos(angle) - p.y * std::sin(angle),
          p.x * std::sin(angle) + p.y * std::cos(angle), 0};
}

StreetAxis one_way(std::int64_t id, Line line, double width = 7) {
  StreetAxis axis{id, std::move(line), 0, width, width, 6, 3};
  axis.leads_backward = false;
  return axis;
}

StreetSettings splitting() {
  StreetSettings settings;
  settings.crossing = Crossing::split;
  return settings;
}

// Carriageways 7 m wide, so far apart, that go on `beyond` metres; traffic keeps right.
std::vector<StreetAxis> crossing(double apart, double across, double beyond) {
  const double a = apart / 2, b = across / 2, x = b + beyond, y = a + beyond;
  return {one_way(1, {{-x, -a, 0}, {x, -a, 0}}), one_way(2, {{x, a, 0}, {-x, a, 0}}),
          one_way(3, {{b, -y, 0}, {b, y, 0}}), one_way(4, {{-b, y, 0}, {-b, -y, 0}})};
}

std::vector<StreetAxis> left_hand(std::vector<StreetAxis> axes) {
  for (StreetAxis& axis : axes) std::swap(axis.leads_forward, axis.leads_backward);
  return axes;
}

std::vector<StreetAxis> turned(std::vector<StreetAxis> axes, double angle) {
  for (StreetAxis& axis : axes)
    for (Point& p : axis.line) p = turned(p, angle);
  return axes;
}

// Every half metre between the axes, off the borders between the surfaces.
void expect_paved(const std::vector<StreetAxis>& axes, double apart, double across, double angle) {
  const Streets town = streets(axes, splitting());
  EXPECT_TRUE(is_roadway(town, turned({0.02, 0.03, 0}, angle))) << apart;
  for (double x = -across / 2 + 0.13; x <= across / 2; x += 0.5)
    for (double y = -apart / 2 + 0.17; y <= apart / 2; y += 0.5)
      ASSERT_TRUE(is_roadway(town, turned({x, y, 0}, angle))) << x << ' ' << y << ' ' << apart;
}

TEST(CrossingMiddle, IsRoadway) {
  for (const auto& [apart, across] : {std::pair{10.0, 12.0}, {16.0, 22.0}, {24.0, 24.0}})
    for (const double angle : {0.0, 0.3, 2.0}) {
      const auto axes = turned(crossing(apart, across, 120), angle);
      expect_paved(axes, apart, across, angle);
      expect_paved(left_hand(axes), apart, across, angle);
    }
}

// One of them begins at the crossing, as the arm of a T does.
TEST(CrossingMiddle, IsRoadwayWhereOneOfThemEnds) {
  auto axes = crossing(16, 20, 120);
  axes[2].line.back() = {10, 8, 0};
  axes[3].line.front() = {-10, 8, 0};
  expect_paved(axes, 16, 20, 0);
}

// A corner by hand there keeps its radius, and no hole lies behind it.
TEST(CrossingMiddle, IsRoadwayBehindACornerByHand) {
  const auto axes = crossing(16, 20, 120);
  StreetOverrides overrides;
  overrides.corners.push_back({{10, -8, 0}, 3, 1, 4});
  const Streets town = streets(axes, splitting(), overrides);
  EXPECT_TRUE(std::any_of(town.corners.begin(), town.corners.end(),
                          [](const Corner& c) { return c.method == Method::by_hand; }));
  EXPECT_TRUE(is_roadway(town, {0.02, 0.03, 0}));
  for (double x = -9.87; x < 10; x += 0.5)
    for (double y = -7.83; y < 8; y += 0.5)
      ASSERT_TRUE(is_roadway(town, {x, y, 0})) << x << ' ' << y;
}

// Between carriageways no median of them is paved beyond their crossing.
TEST(CrossingMiddle, LeavesTheMedians) {
  const Streets town = streets(crossing(20, 20, 120), splitting());
  for (const Point& p : {Point{40, 0, 0}, {-40, 0, 0}, {0, 40, 0}, {0, -40, 0}})
    EXPECT_FALSE(is_roadway(town, p)) << p.x << ' ' << p.y;
}

// Streets of a grid that run in turn this way and that enclose blocks, at its rim too.
TEST(CrossingMiddle, IsNoBlockOfAGrid) {
  constexpr double apart = 25;
  std::vector<StreetAxis> axes;
  for (int i = 0; i < 4; ++i) {
    Line row{{-60, i * apart, 0}, {135, i * apart, 0}},
        column{{i * apart, -60, 0}, {i * apart, 135, 0}};
    if (i % 2 == 1) std::reverse(row.begin(), row.end());
    if (i % 2 == 0) std::reverse(column.begin(), column.end());
    axes.push_back(one_way(2 * i + 1, row));
    axes.push_back(one_way(2 * i + 2, column));
  }
  const Streets town = streets(axes, splitting());
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      EXPECT_FALSE(is_roadway(town, {(i + 0.5) * apart, (j + 0.5) * apart, 0})) << i << ' ' << j;
}

// Four points may draw a ring, of which its source says so.
TEST(CrossingMiddle, IsNoIslandOfASquareThatIsARing) {
  std::vector<StreetAxis> axes;
  const auto add = [&](Line line, bool on_ring) {
    axes.push_back(one_way(static_cast<std::int64_t>(axes.size()) + 1, std::move(line)));
    axes.back().on_ring = on_ring;
  };
  for (int quarter = 0; quarter < 4; ++quarter) {
    const double angle = quarter * M_PI / 2;
    const Point from = turned({-12, -12, 0}, angle), to = turned({12, -12, 0}, angle);
    add({from, to}, true);
    add({turned({-150, -12, 0}, angle), from}, false);
    add({to, turned({150, -12, 0}, angle)}, false);
  }
  EXPECT_FALSE(is_roadway(streets(axes, splitting()), {0.3, 0.2, 0}));
  for (StreetAxis& axis : axes) axis.on_ring = false;
  EXPECT_TRUE(is_roadway(streets(axes, splitting()), {0.3, 0.2, 0}));
}

// Its sides bend: they are those of a ring, whose arms part into one-way streets.
TEST(CrossingMiddle, IsNoIslandOfARing) {
  constexpr double radius = 15;
  const double c = radius / std::sqrt(2);
  std::vector<StreetAxis> axes;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const double start = -3 * M_PI / 4 + quarter * M_PI / 2;
    Line side;
    for (int k = 0; k <= 8; ++k) {
      const double at = start + k * M_PI / 16;
      side.push_back({radius * std::cos(at), radius * std::sin(at), 0});
    }
    const double angle = quarter * M_PI / 2;
    side.front() = turned({-c, -c, 0}, angle);
    side.back() = turned({c, -c, 0}, angle);
    axes.push_back(one_way(3 * quarter + 1, side));
    axes.push_back(one_way(3 * quarter + 2, {turned({-150, -c, 0}, angle), side.front()}));
    axes.push_back(one_way(3 * quarter + 3, {side.back(), turned({150, -c, 0}, angle)}));
  }
  EXPECT_FALSE(is_roadway(streets(axes, splitting()), {0, 0, 0}));
}

}  // namespace crossing_middle_test
}  // namespace streetgen
