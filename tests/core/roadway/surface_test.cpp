#include "streetgen/surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/geos.hpp"
#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "rounds.hpp"
#include "streetgen/error.hpp"

namespace streetgen {
namespace surface_test {

Line ray(double angle, double size) {
  return {{0, 0, 0}, {size * std::cos(angle), size * std::sin(angle), 0}};
}

bool valid(const MultiPolygon& surface) {
  Geos geos;
  return geos.valid(geos.surface(surface).get());
}

TEST(BorderLine, RunsFromTheLeftKerbToTheRightKerb) {
  const Line border = border_line({{0, 0, 0}, {10, 0, 0}}, 4, 6);
  ASSERT_EQ(border.size(), 2u);
  EXPECT_NEAR(border[0].x, 4, 1e-12);
  EXPECT_NEAR(border[0].y, 3, 1e-12);
  EXPECT_NEAR(border[1].y, -3, 1e-12);
}

TEST(BorderLine, IsClampedToTheAxis) {
  EXPECT_NEAR(border_line({{0, 0, 0}, {10, 0, 0}}, 99, 6)[0].x, 10, 1e-12);
  EXPECT_NEAR(border_line({{0, 0, 0}, {10, 0, 0}}, -5, 6)[0].x, 0, 1e-12);
}

TEST(SectionSurface, OfAStraightAxisIsItsLengthTimesItsWidth) {
  const MultiPolygon surface = section_surface({{0, 0, 0}, {50, 0, 0}}, 7, 10, 40);
  EXPECT_NEAR(area(surface), 30 * 7, 1e-9);
}

TEST(SectionSurface, IsEmptyWhereTheAbscissasCross) {
  EXPECT_TRUE(section_surface({{0, 0, 0}, {50, 0, 0}}, 7, 30, 20).empty());
}

// A bend by theta: both rectangles, the outer sector, less the inner overlap twice counted.
TEST(SectionSurface, OfABendHasARoundOutsideAndAMitredInside) {
  const double theta = M_PI / 3, half = 3, size = 40;
  const Line axis{
      {0, 0, 0}, {size, 0, 0}, {size + size * std::cos(theta), size * std::sin(theta), 0}};
  // The sector in six chords: eight a quarter.
  const double sector = 6 * std::sin(theta / 6) * half * half / 2,
               inner = half * half * std::tan(theta / 2);
  const MultiPolygon surface = section_surface(axis, 2 * half, 0, 2 * size);
  EXPECT_NEAR(area(surface), 2 * size * 2 * half + sector - inner, 1e-9);
  EXPECT_TRUE(valid(surface));
}

TEST(SectionSurface, IsValidOnRoughAxes) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 500; ++i) {
    Line axis{{0, 0, 0}};
    for (int k = 0; k < 8; ++k)
      axis.push_back({axis.back().x + 1 + (random() % 1000) / 100.0,
                      axis.back().y + (random() % 2000) / 100.0 - 10, 0});
    const MultiPolygon surface = section_surface(axis, 6, 2, length(axis) - 2);
    ASSERT_FALSE(surface.empty()) << i;
    ASSERT_TRUE(valid(surface)) << i;
    for (const Point& p : substring(axis, 2.5, length(axis) - 2.5)) {
      bool covered = false;
      for (const Polygon& part : surface) covered = covered || inside(p, part);
      ASSERT_TRUE(covered) << i;
    }
  }
}

// A square crossing: the cross of the arms out to r + w, and four corners of (1 - pi / 4) r^2.
TEST(IntersectionSurface, OfASquareCrossingHasTheDerivedArea) {
  const double half = 3.5, r = 5;
  std::vector<Line> axes;
  for (const int quarter : {2, 0, 3, 1}) axes.push_back(ray(quarter * M_PI_2, 60));
  const MultiPolygon surface =
      intersection_surface(axes, std::vector<double>(4, 2 * half), std::vector<double>(4, r));
  const double cross = 4 * half * half + 4 * r * 2 * half;
  const double corners = 4 * (1 - M_PI / 4) * r * r;
  // Sixteen chords a quarter cut into the corner's hollow side.
  const double chords = 4 * r * r / 2 * (M_PI_2 - 16 * std::sin(M_PI / 32));
  EXPECT_NEAR(area(surface), cross + corners + chords, 1e-9);
}

TEST(IntersectionSurface, DoesNotDependOnTheOrderOfTheAxes) {
  const std::vector<Line> axes{ray(0.1, 80), ray(1.5, 80), ray(3.3, 80), ray(4.6, 80)};
  const std::vector<double> widths{6, 8, 10, 7}, radii{3, 4, 5, 6};
  const double whole = area(intersection_surface(axes, widths, radii));
  const MultiPolygon turned =
      intersection_surface({axes[2], axes[0], axes[3], axes[1]}, {10, 6, 7, 8}, {5, 3, 6, 4});
  EXPECT_NEAR(area(turned), whole, 1e-6);
}

TEST(IntersectionSurface, IsValidAndNotEmptyForRandomStraightAxes) {
  std::mt19937_64 random(11);
  for (int i = 0; i < rounds(2000); ++i) {
    std::vector<Line> axes;
    std::vector<double> widths, radii;
    const int degree = 3 + random() % 4;
    for (int k = 0; k < degree; ++k) {
      axes.push_back(ray((random() % 62831) / 1e4, 5 + random() % 200));
      widths.push_back(3 + (random() % 200) / 10.0);
      radii.push_back((random() % 100) / 10.0);
    }
    const MultiPolygon surface = intersection_surface(axes, widths, radii);
    ASSERT_FALSE(surface.empty()) << i;
    ASSERT_TRUE(valid(surface)) << i;
  }
}

// A side street on a street straight on, up to rounding: the far kerb is the straight line.
TEST(IntersectionSurface, OfATLeavesTheFarKerbStraight) {
  for (const double off : {0., 1e-9, -1e-9, 1e-6, -1e-6}) {
    const MultiPolygon surface = intersection_surface(
        {ray(0, 80), ray(M_PI + off, 80), ray(M_PI_2, 80)}, {12, 12, 5}, {5, 5, 5});
    for (const Point& p : surface[0][0]) EXPECT_GT(p.y, -6.01) << off;
  }
}

// Of a side street wider than the one that it leaves, at an acute angle, no corner sticks out.
TEST(IntersectionSurface, OfAnAcuteTLeavesTheFarKerbStraight) {
  const MultiPolygon surface = intersection_surface(
      {ray(0, 80), ray(M_PI, 80), ray(14 * M_PI / 180, 80)}, {6, 6, 7}, {3, 3, 3});
  for (const Point& p : surface[0][0]) EXPECT_GT(p.y, -3.01);
}

// Whatever the bend, the intersection stays within its arms, their bends and their corners.
TEST(IntersectionSurface, OfAForkIsAsSymmetricAsItsAxes) {
  constexpr double half_fork = 25 * M_PI / 180, half_width = 10;
  for (const double turned : {0.0, 1.0, 2.5}) {
    const MultiPolygon surface = intersection_surface(
        {ray(turned, 80), ray(turned + M_PI - half_fork, 80), ray(turned + M_PI + half_fork, 80)},
        {2 * half_width, 8, 8}, {6, 6, 6});
    const Point out = ray(turned, 1)[1], across = left_normal(out);
    for (double at = 0.01; at < half_width; at += 0.25)
      for (double behind = 0.05; behind < half_width; behind += 0.25)
        EXPECT_EQ(inside(across * at - out * behind, surface.front()),
                  inside(across * -at - out * behind, surface.front()))
            << at << ' ' << behind;
  }
}

// A wide street goes straight on, and a narrow one leaves it so slightly that its corner with the
// far half would be on the wide one's roadway.
TEST(IntersectionSurface, HoldsAStreetThatGoesStraightOnBesideOneThatLeaves) {
  constexpr double half = 6, degree = M_PI / 180;
  for (const int side : {+1, -1}) {
    const MultiPolygon surface = intersection_surface(
        {ray(0, 60), ray(side * 190 * degree, 60), ray(side * 32 * degree, 60)},
        {2 * half, 2 * half, 3.5}, {6, 6, 6});
    for (double abscissa = 0.05; abscissa < 10; abscissa += 0.1)
      for (double across = -half + 0.01; across < half; across += 0.1)
        EXPECT_TRUE(inside({abscissa, across, 0}, surface.front())) << abscissa << ' ' << across;
  }
}

// A ramp that leaves a wide street within its width may turn less than the street does.
TEST(IntersectionSurface, HoldsAStreetThatKeepsItsWidthBesideAStraighterRamp) {
  constexpr double half = 5, degree = M_PI / 180;
  for (const int side : {+1, -1}) {
    const Line street = ray(side * -4 * degree, 300);
    const MultiPolygon surface = intersection_surface(
        {street, ray(M_PI, 300), ray(side * degree, 300)}, {2 * half, 2 * half, 3.5}, {6, 6, 6});
    const Point along = street[1] * (1.0 / 300), across = left_normal(along);
    for (double abscissa = 0.05; abscissa < 100; abscissa += 1)
      for (double off = -half + 0.01; off < half; off += 0.1)
        EXPECT_TRUE(inside(along * abscissa + across * off, surface.front()))
            << abscissa << ' ' << off;
  }
}

// The wide street's flat end leans over the kerb across; its nose touches the outside of its bend.
TEST(IntersectionSurface, LeavesTheFarKerbStraightWhereAnArcTouchesTheOutsideOfABend) {
  const Line through_north{{0, 0, 0}, {3.2, 59.2, 0}}, through_south{{0, 0, 0}, {-1.5, -28, 0}},
      side{{0, 0, 0}, {4.867, 6.592, 0}, {11.769, 7.397, 0}, {18.707, 5.327, 0}};
  const MultiPolygon surface =
      intersection_surface({side, through_north, through_south}, {7, 4, 4}, {0.75, 0, 6.25});
  ASSERT_EQ(surface.size(), 1u);
  for (const Point& p : surface.front().front()) EXPECT_GT(p.x, p.y / 18.5 - 2.01);
}

// The end of an arm behind the node lies on the section of the street that it leaves.
TEST(IntersectionSurface, EndsAtTheLimitsOfAFork) {
  constexpr double half = 5.5, degree = M_PI / 180;
  const MultiPolygon surface =
      intersection_surface({ray(180 * degree, 60), ray(38 * degree, 60), ray(-7 * degree, 60)},
                           {11, 9.8, 11}, {3, 3, 3});
  double limit = 0, farthest = 0;
  for (const Point& p : surface.front().front()) {
    farthest = std::max(farthest, -p.x);
    if (std::abs(p.y) > half - 1e-6) limit = std::max(limit, -p.x);
  }
  EXPECT_NEAR(farthest, limit, 1e-6);
}

// A narrow street crosses a wide one so slightly that the wide one's kerb lies outside, all round.
TEST(IntersectionSurface, IsRoundOutsideOfAStreetThatBendsWhereANarrowOneCrossesIt) {
  constexpr double half = 5.25, degree = M_PI / 180;
  const MultiPolygon surface = intersection_surface(
      {ray(14 * degree, 60), ray(176 * degree, 60), ray(190 * degree, 60), ray(-10 * degree, 60)},
      {2 * half, 2 * half, 7, 7}, {3, 3, 3, 3});
  for (double angle = 266 * degree + 0.01; angle < 284 * degree; angle += 0.02)
    EXPECT_TRUE(inside(ray(angle, half - 0.02)[1], surface.front())) << angle / degree;
}

TEST(IntersectionSurface, OfABendStaysNearItsAxes) {
  for (double bend = -0.3; bend <= 0.3; bend += 0.001) {
    Line a = ray(0.7, 80), b = ray(0.7 + M_PI + bend, 80);
    for (Line* axis : {&a, &b})
      for (Point& p : *axis) p = p + Point{650580, 6859994, 0};
    const MultiPolygon surface = intersection_surface({a, b}, {14, 14}, {6.25, 6.25});
    for (const Polygon& part : surface)
      for (const Point& p : part[0])
        EXPECT_LT(std::min(distance_to_line(p, a), distance_to_line(p, b)), 7.2) << bend;
  }
}

TEST(IntersectionRing, KeepsTheArcsTrue) {
  std::vector<Line> axes;
  for (int quarter = 0; quarter < 4; ++quarter) axes.push_back(ray(quarter * M_PI_2, 60));
  const CurvedRing ring =
      intersection_ring(axes, std::vector<double>(4, 7.0), std::vector<double>(4, 5.0));
  int arcs = 0;
  for (const RingPiece& piece : ring) arcs += piece.curved;
  EXPECT_EQ(arcs, 4);
  for (std::size_t i = 0; i < ring.size(); ++i)
    EXPECT_NEAR(distance(ring[i].arc.end, ring[(i + 1) % ring.size()].arc.start), 0, 1e-9);
}

// Corners of 3 m and half widths of 3 m: every arc starts or ends where a border line does, but for
// what the angles lack to 90 degrees.
TEST(IntersectionRing, IsOnePieceWhereArcsEndAtBorderLines) {
  const Point node{6567398.268, 5575409.416, 0};
  const std::vector<Line> axes = {{node, {6567382.343, 5575246.92, 0}},
                                  {node, {6567405.124, 5575479.371, 0}},
                                  {node, {6567199.767, 5575428.87, 0}}};
  EXPECT_FALSE(intersection_ring(axes, {6, 6, 6}, {3, 3, 3}).empty());
}

TEST(IntersectionSurface, RefusesListsOfDifferentLength) {
  EXPECT_THROW(intersection_surface({ray(0, 5), ray(2, 5)}, {7}, {5, 5}), Error);
}

TEST(VariableBuffer, OfAStraightLineIsATrapezoid) {
  const MultiPolygon both = variable_buffer({{0, 0, 0}, {20, 0, 0}}, {2, 5});
  EXPECT_NEAR(area(both), 20 * 7, 1e-9);
  const MultiPolygon left = variable_buffer({{0, 0, 0}, {20, 0, 0}}, {2, 5}, Side::left);
  EXPECT_NEAR(area(left), 20 * 3.5, 1e-9);
}

TEST(VariableBuffer, RoundEndsAddTwoHalfDiscs) {
  const MultiPolygon surface =
      variable_buffer({{0, 0, 0}, {20, 0, 0}}, {3, 3}, Side::both, Ends::round);
  EXPECT_NEAR(area(surface), 20 * 6 + M_PI * 9, 0.3);
}

}  // namespace surface_test
}  // namespace streetgen
