#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/enclosing_circle.hpp"
#include "geometry/fit_circle.hpp"
#include "geometry/polyline.hpp"
#include "streetgen/roundabout.hpp"

namespace streetgen {
namespace {

constexpr double pi = 3.14159265358979323846;

Line arc(const Point& centre, double radius, double from, double to, int sides) {
  Line line;
  for (int i = 0; i <= sides; ++i) {
    const double at = (from + (to - from) * i / sides) * pi / 180;
    line.push_back(centre + Point{std::cos(at), std::sin(at), 0} * radius);
  }
  return line;
}

Line circle(const Point& centre, double radius, int sides = 24) {
  Line line = arc(centre, radius, 0, 360, sides);
  line.back() = line.front();
  return line;
}

RingAxis arm(std::int64_t axis_id, const Point& centre, double radius, double angle) {
  const Point out{std::cos(angle * pi / 180), std::sin(angle * pi / 180), 0};
  return {axis_id, {centre + out * radius, centre + out * (radius + 60)}};
}

std::vector<RingAxis> roundabout(const Point& centre, double radius, OneWay one_way) {
  std::vector<RingAxis> axes{{1, circle(centre, radius), 0, one_way}};
  for (int a = 0; a < 4; ++a) axes.push_back(arm(2 + a, centre, radius, 90 * a));
  return axes;
}

TEST(NetworkRings, TellsARoundabout) {
  const auto rings = network_rings(roundabout({100, 200}, 20, OneWay::along), {});
  ASSERT_EQ(rings.size(), 1u);
  const NetworkRing& ring = rings[0];
  EXPECT_LT(distance(ring.centre, {100, 200, 0}), 1e-3);
  EXPECT_NEAR(ring.radius, 20, 0.2);
  EXPECT_DOUBLE_EQ(ring.on_circle, 1);
  EXPECT_GT(ring.fill, 0.97);
  // Places on edges are known to the millimetre.
  EXPECT_NEAR(ring.one_way, 1, 1e-4);
  EXPECT_EQ(ring.against, 0);
  EXPECT_EQ(ring.arm_nodes, 4);
  EXPECT_EQ(ring.single_arm, 1);
  EXPECT_EQ(ring.inside, 0);
  EXPECT_EQ(ring.edges.size(), 4u);
  EXPECT_EQ(ring.arms.size(), 4u);
  for (const RingEdge& edge : ring.edges) EXPECT_TRUE(edge.along_axis);
  for (const RingEdge& edge : ring.arms) EXPECT_FALSE(edge.along_axis);
}

TEST(NetworkRings, GoesTheOtherWayOnTheLeft) {
  RingSettings left;
  left.counter_clockwise = false;
  const auto rings = network_rings(roundabout({0, 0}, 20, OneWay::along), left);
  ASSERT_EQ(rings.size(), 1u);
  EXPECT_EQ(rings[0].one_way, 0);
  EXPECT_NEAR(rings[0].against, 1, 1e-4);
  for (const RingEdge& edge : rings[0].edges) EXPECT_FALSE(edge.along_axis);
}

TEST(NetworkRings, CountsWhatLiesInside) {
  std::vector<RingAxis> axes = roundabout({0, 0}, 20, OneWay::no);
  axes.push_back({9, {{20, 0}, {5, 0}}});
  axes.push_back({10, {{-5, 0}, {-8, 3}}});
  const auto rings = network_rings(axes, {});
  ASSERT_EQ(rings.size(), 1u);
  EXPECT_EQ(rings[0].inside, 2);
  EXPECT_EQ(rings[0].edges.size(), 4u);
  EXPECT_GT(rings[0].fill, 0.97);
}

TEST(NetworkRings, KeepsToItsBounds) {
  EXPECT_TRUE(network_rings(roundabout({0, 0}, 2, OneWay::no), {}).empty());
  EXPECT_TRUE(network_rings(roundabout({0, 0}, 70, OneWay::no), {}).empty());
  EXPECT_TRUE(network_rings({}, {}).empty());
  EXPECT_TRUE(network_rings({{1, {{0, 0}, {90, 0}}}}, {}).empty());
}

// A street that passes without a node makes two faces of a ring; one that ends within makes none.
TEST(NetworkRings, OfStreetsThatCrossWithoutANodeAreNone) {
  std::vector<RingAxis> crossed = roundabout({0, 0}, 20, OneWay::no), overshot = crossed;
  crossed.push_back({9, {{-80, 7}, {80, 9}}});
  EXPECT_TRUE(network_rings(crossed, {}).empty());
  overshot.push_back({9, {{3, 7}, {80, 9}}});
  const auto rings = network_rings(overshot, {});
  ASSERT_EQ(rings.size(), 1u);
  EXPECT_EQ(rings[0].edges.size(), 4u);
}

TEST(NetworkRings, OtherLevelsCloseNoRing) {
  EXPECT_TRUE(network_rings({{1, arc({0, 0}, 20, 0, 180, 12), 0}, {2, arc({0, 0}, 20, 180, 360, 12), 1}}, {})
                  .empty());
}

TEST(NetworkRings, DoNotDependOnTheOrderOfAxes) {
  std::vector<RingAxis> axes = roundabout({0, 0}, 20, OneWay::along);
  const auto before = network_rings(axes, {});
  std::swap(axes[0], axes[3]);
  const auto after = network_rings(axes, {});
  ASSERT_EQ(before.size(), after.size());
  EXPECT_EQ(before[0].edges.size(), after[0].edges.size());
  EXPECT_EQ(before[0].edges[0].axis_id, after[0].edges[0].axis_id);
  EXPECT_TRUE(same(before[0].line, after[0].line));
}

TEST(EnclosingCircle, HoldsAllPointsAndIsTheSmallest) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> within(-50, 50);
  for (int i = 0; i < 500; ++i) {
    Line points;
    for (int k = 0; k < 3 + i % 20; ++k) points.push_back({within(random), within(random), 0});
    const Circle found = enclosing_circle(points);
    int on = 0;
    for (const Point& p : points) {
      EXPECT_LE(distance(p, found.centre), found.radius + 1e-5);
      on += distance(p, found.centre) > found.radius - 1e-5;
    }
    EXPECT_GE(on, 2);
    // A smaller one would hold three of its points, or the two farthest apart.
    double widest = 0;
    for (const Point& p : points)
      for (const Point& q : points) widest = std::max(widest, distance(p, q));
    EXPECT_GE(2 * found.radius, widest - 1e-5);
    EXPECT_LE(2 * found.radius, widest * 2 / std::sqrt(3.0) + 1e-5);
  }
}

TEST(FitCircle, FindsTheCircleOfItsPoints) {
  const Line points = arc({650000, 6860000}, 35, 10, 70, 9);
  const auto circle = fit_circle(points.data(), points.size());
  ASSERT_TRUE(circle);
  EXPECT_NEAR(circle->radius, 35, 1e-6);
  const Line straight{{0, 0}, {1, 1}, {2, 2}, {7, 7}};
  EXPECT_FALSE(fit_circle(straight.data(), straight.size()));
  EXPECT_FALSE(fit_circle(points.data(), 2));
}

}  // namespace
}  // namespace streetgen
