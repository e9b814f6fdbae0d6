#include "streetgen/corner.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/polyline.hpp"

namespace streetgen {
namespace corner_test {

Line ray(double angle, double size) {
  return {{0, 0, 0}, {size * std::cos(angle), size * std::sin(angle), 0}};
}

double degrees(double d) { return d * M_PI / 180; }

// Two straight axes: the derivation is in docs/concepts/geometry.md.
TEST(CornerArc, StraightAxesHaveTheDerivedLimit) {
  for (const double phi : {30., 60., 90., 120., 150.}) {
    const double p = degrees(phi), a = 3.5, b = 3.5, r = 5;
    const auto corner = corner_arc(ray(0, 100), ray(p, 100), 2 * a, 2 * b, r);
    ASSERT_TRUE(corner) << phi;
    EXPECT_NEAR(corner->abscissa_a, ((b + r) + (a + r) * std::cos(p)) / std::sin(p), 1e-9) << phi;
  }
}

TEST(CornerArc, TouchesAxesWithoutWidth) {
  const auto corner = corner_arc(ray(0, 100), ray(degrees(90), 100), 0, 0, 5);
  ASSERT_TRUE(corner);
  EXPECT_NEAR(distance(corner->centre, {5, 5, 0}), 0, 1e-9);
  EXPECT_NEAR(corner->abscissa_a, 5, 1e-9);
  EXPECT_NEAR(corner->abscissa_b, 5, 1e-9);
}

TEST(CornerArc, TouchesBothBordersWhateverTheWidthsAndTheAngle) {
  std::mt19937_64 random(20261121);
  const auto between = [&](double low, double high) {
    return low + (high - low) * (random() >> 11) * 0x1p-53;
  };
  for (int i = 0; i < 2000; ++i) {
    const double start = between(0, 2 * M_PI), phi = degrees(between(20, 160));
    const double wa = between(3, 20), wb = between(3, 20), r = between(0.15, 15);
    const Line a = ray(start, 500), b = ray(start + phi, 500);
    const auto corner = corner_arc(a, b, wa, wb, r);
    ASSERT_TRUE(corner) << wa << ' ' << wb << ' ' << phi;
    EXPECT_NEAR(distance_to_line(corner->centre, a), wa / 2 + r, 1e-6);
    EXPECT_NEAR(distance_to_line(corner->centre, b), wb / 2 + r, 1e-6);
    EXPECT_NEAR(distance_to_line(corner->arc.start, a), wa / 2, 1e-6);
    EXPECT_NEAR(distance_to_line(corner->arc.end, b), wb / 2, 1e-6);
    for (const Point& p : {corner->arc.start, corner->arc.middle, corner->arc.end})
      EXPECT_NEAR(distance(p, corner->centre), r, 1e-6);
  }
}

TEST(CornerArc, LiesCounterClockwiseFromAToB) {
  const auto corner = corner_arc(ray(0, 50), ray(degrees(90), 50), 6, 6, 4);
  ASSERT_TRUE(corner);
  EXPECT_NEAR(corner->centre.x, 7, 1e-9);
  EXPECT_NEAR(corner->centre.y, 7, 1e-9);
  EXPECT_NEAR(corner->arc.start.y, 3, 1e-9);
  EXPECT_NEAR(corner->arc.end.x, 3, 1e-9);
}

// b runs back beside a: the centre nearest to the node by Euclid is found on the bend.
TEST(CornerArc, FindsTheCornerOfBentAxes) {
  const Line a{{0, 0, 0}, {20, 0, 0}, {20, 30, 0}};
  const Line b{{0, 0, 0}, {0, 40, 0}};
  const auto corner = corner_arc(a, b, 6, 6, 4);
  ASSERT_TRUE(corner);
  EXPECT_NEAR(corner->centre.x, 7, 1e-9);
  EXPECT_NEAR(corner->centre.y, 7, 1e-9);
}

TEST(CornerArc, NoneWhereOneAxisLiesWithinTheOther) {
  const Line a = ray(0, 30), b = ray(degrees(2), 10);
  EXPECT_FALSE(corner_arc(a, b, 20, 4, 5));
  EXPECT_FALSE(arc_centre(a, b, 20, 4, 5));
}

// Two circles are as near to the node of a street of Marseille: one about its end, and one against
// a bend a metre on. The nearer feet decide, whichever street is looked at first.
TEST(CornerArc, IsTheSameInTheMirrorWhereTwoAreAsNear) {
  const Line a{{0.4, -0.2, 0}, {1, -2.3, 0}, {2.4, -7.7, 0}, {3.9, -12, 0}, {6.1, -19.7, 0}};
  const Line b{{0.4, -0.2, 0}, {0.2, 0.3, 0}, {-2.2, 9.1, 0}, {-3.4, 13.8, 0}, {-6.1, 24, 0}};
  const auto placed = [](Line line, double side) {
    for (Point& p : line) p = {side * (894799 + p.x), 6245588 + p.y, 0};
    return line;
  };
  for (const double radius : {1., 6., 6.25, 6.3, 7.}) {
    const auto drawn = corner_arc(placed(a, 1), placed(b, 1), 7, 7, radius);
    const auto mirrored = corner_arc(placed(b, -1), placed(a, -1), 7, 7, radius);
    ASSERT_TRUE(drawn && mirrored) << radius;
    EXPECT_NEAR(drawn->abscissa_a, mirrored->abscissa_b, 1e-3) << radius;
    EXPECT_NEAR(drawn->abscissa_b, mirrored->abscissa_a, 1e-3) << radius;
  }
}

// An on-ramp of Manhattan and its highway, led back behind their node: of circles that touch both,
// the one by the node is meant, whichever of the two is a.
TEST(CornerArc, IsNearestToTheNodeThatIsGiven) {
  const Line link{{34.9584, 56.781, 0}, {18.6937, 26.0588, 0}, {-54.6175, -77.2867, 0}};
  const Line highway{{34.9584, 56.781, 0}, {55.2477, 87.0288, 0}, {132.8155, 212.9853, 0}};
  const auto led_back = [](Line line, double side, double by) {
    line[0] = line[0] - unit(line[1] - line[0]) * by;
    for (Point& p : line) p.x *= side;
    return line;
  };
  for (const double radius : {100., 500., 1000., 2000.}) {
    const double by = 4 * (8.25 + radius);
    const auto drawn =
        corner_arc(led_back(link, 1, by), led_back(highway, 1, by), 6, 10.5, radius, link.front());
    const auto mirrored = corner_arc(led_back(highway, -1, by), led_back(link, -1, by), 10.5, 6,
                                     radius, {-link.front().x, link.front().y, 0});
    ASSERT_TRUE(drawn && mirrored) << radius;
    EXPECT_NEAR(drawn->abscissa_a, mirrored->abscissa_b, 1e-4) << radius;
    EXPECT_NEAR(drawn->abscissa_b, mirrored->abscissa_a, 1e-4) << radius;
  }
}

TEST(MaxCornerRadius, EqualsTheDerivedOne) {
  for (const double phi : {40., 60., 90., 120.}) {
    const double p = degrees(phi), a = 3, b = 4, size = 30;
    const auto radius = max_corner_radius(ray(0, size), ray(p, 300), 2 * a, 2 * b);
    const double fits_a = (size * std::sin(p) - b - a * std::cos(p)) / (1 + std::cos(p));
    ASSERT_TRUE(radius);
    EXPECT_NEAR(*radius, fits_a, 1e-5) << phi;
  }
}

TEST(MaxCornerRadius, NoneWhereNotEvenTheBordersMeet) {
  EXPECT_FALSE(max_corner_radius(ray(0, 2), ray(degrees(10), 2), 6, 6));
}

// Two streets that part and come back: the largest circle between may touch both sides of a bend.
TEST(MaxCornerRadius, LeavesTheSameArcInTheMirror) {
  const auto mirrored = [](Line line) {
    for (Point& p : line) p.x = -p.x;
    return line;
  };
  std::mt19937 random(1);
  std::uniform_real_distribution<double> aside(5, 9);
  for (int round = 0; round < 500; ++round) {
    Line a{{0, 0, 0}}, b{{0, 0, 0}};
    for (int k = 1; k <= 5; ++k) {
      a.push_back({k < 5 ? aside(random) : 5, 12.0 * k, 0});
      b.push_back({k < 5 ? -aside(random) : -5, 12.0 * k + 3, 0});
    }
    const auto largest = max_corner_radius(a, b, 6, 6, 8);
    ASSERT_TRUE(largest.has_value());
    const auto one = corner_arc(a, b, 6, 6, *largest),
               other = corner_arc(mirrored(b), mirrored(a), 6, 6, *largest);
    ASSERT_TRUE(one && other) << round;
    EXPECT_NEAR(one->abscissa_a, other->abscissa_b, 1e-4) << round;
    EXPECT_NEAR(one->abscissa_b, other->abscissa_a, 1e-4) << round;
  }
}

}  // namespace corner_test
}  // namespace streetgen
