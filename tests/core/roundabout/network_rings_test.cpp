#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/enclosing_circle.hpp"
#include "geometry/fit_circle.hpp"
#include "geometry/polyline.hpp"
#include "streetgen/roundabout.hpp"

namespace streetgen {
namespace network_rings_test {

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
  EXPECT_GT(ring.compactness, 0.97);
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
  EXPECT_EQ(rings[0].inside, 3);  // one end, and two
  EXPECT_EQ(rings[0].edges.size(), 4u);
  EXPECT_GT(rings[0].compactness, 0.97);
}

// A street that leads through the middle parts the ground within, and not the ring.
TEST(NetworkRings, OfTaggedAxesAreWholeWhateverLiesWithin) {
  std::vector<RingAxis> axes = roundabout({0, 0}, 20, OneWay::along);
  axes.push_back({9, {{20, 0}, {0, 0}, {-20, 0}}});
  axes.push_back({10, {{0, 0}, {0, 12}}});
  const auto parted = network_rings(axes, {});
  for (const NetworkRing& ring : parted) EXPECT_LT(ring.one_way, 0.7);
  axes[0].tagged = true;
  const auto rings = network_rings(axes, {});
  ASSERT_EQ(rings.size(), 1u);
  EXPECT_NEAR(rings[0].radius, 20, 0.2);
  EXPECT_NEAR(rings[0].one_way, 1, 1e-4);
  EXPECT_EQ(rings[0].edges.size(), 4u);
  EXPECT_EQ(rings[0].faces.size(), 1u);
  EXPECT_EQ(rings[0].arms.size(), 6u);  // two of them within
  // As it is where nothing lies within, but for that.
  std::vector<RingAxis> plain = roundabout({0, 0}, 20, OneWay::along), tagged = plain;
  tagged[0].tagged = true;
  const auto found = network_rings(tagged, {});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(distance(found[0].centre, network_rings(plain, {})[0].centre), 0);
  EXPECT_EQ(found[0].arms.size(), 4u);
}

// A racetrack is long, and a roundabout where a source says so; a tagged arc closes nothing.
TEST(NetworkRings, OfTaggedAxesMayBeLongOrTiny) {
  Line track = arc({60, 0}, 8, -90, 90, 12);
  const Line back = arc({-20, 0}, 8, 90, 270, 12);
  track.insert(track.end(), back.begin(), back.end());
  track.push_back(track.front());
  RingSettings settings;
  settings.shape_least = 0.6;
  EXPECT_TRUE(network_rings({{1, track}}, settings).empty());
  EXPECT_EQ(network_rings({{1, track, 0, OneWay::along, true}}, settings).size(), 1u);
  EXPECT_TRUE(network_rings({{1, circle({0, 0}, 2)}}, {}).empty());
  EXPECT_EQ(network_rings({{1, circle({0, 0}, 2), 0, OneWay::along, true}}, {}).size(), 1u);
  const std::vector<RingAxis> half{{1, arc({0, 0}, 20, 0, 180, 12), 0, OneWay::along, true},
                                   {2, arc({0, 0}, 20, 180, 360, 12), 0, OneWay::along, false}};
  ASSERT_EQ(network_rings(half, {}).size(), 1u);
  EXPECT_NEAR(network_rings(half, {})[0].one_way, 1, 1e-4);
}

// It has no edge, which a ring could take.
TEST(NetworkRings, LeaveOutAnAxisThatLiesOnAnother) {
  std::vector<RingAxis> axes = roundabout({0, 0}, 20, OneWay::no);
  Line half(axes[0].line.begin(), axes[0].line.begin() + 7);
  axes.push_back({9, half});
  axes.back().importance = 98;  // it goes before
  const auto rings = network_rings(axes, {});
  ASSERT_EQ(rings.size(), 1u);
  double length = 0;
  for (const RingEdge& edge : rings[0].edges) length += edge.end_abscissa - edge.start_abscissa;
  EXPECT_NEAR(length, 2 * pi * 20, 1);
  for (const RingEdge& edge : rings[0].edges)
    EXPECT_TRUE(edge.axis_id == 9 || edge.start_abscissa > 2 * pi * 20 / 4 - 1);
}

TEST(NetworkRings, HaveTheEdgesThatSignalsInMidBlockCut) {
  std::vector<RingAxis> axes = roundabout({0, 0}, 20, OneWay::no);
  axes[0].controls = {{1, 12}};
  axes[1].controls = {{2, 40}};
  RingSettings settings;
  settings.controls = {10, 5};
  const auto rings = network_rings(axes, settings);
  ASSERT_EQ(rings.size(), 1u);
  EXPECT_EQ(rings[0].edges.size(), 5u);
  EXPECT_EQ(rings[0].edges[0].end_abscissa, 12);
  EXPECT_EQ(rings[0].arm_nodes, 4);
  ASSERT_EQ(rings[0].arms.size(), 4u);
  EXPECT_EQ(rings[0].arms[0].end_abscissa, 40);
  axes[0].tagged = true;
  EXPECT_EQ(network_rings(axes, settings).at(0).edges.size(), 4u);
}

TEST(NetworkRings, KeepsToItsBounds) {
  EXPECT_TRUE(network_rings(roundabout({0, 0}, 2, OneWay::no), {}).empty());
  EXPECT_TRUE(network_rings(roundabout({0, 0}, 70, OneWay::no), {}).empty());
  EXPECT_TRUE(network_rings({}, {}).empty());
  EXPECT_TRUE(network_rings({{1, {{0, 0}, {90, 0}}}}, {}).empty());
}

// Such a street passes above or below.
TEST(NetworkRings, AreNotPartedByStreetsThatCrossWithoutANode) {
  std::vector<RingAxis> crossed = roundabout({0, 0}, 20, OneWay::no), overshot = crossed;
  crossed.push_back({9, {{-80, 7}, {80, 9}}});
  overshot.push_back({9, {{3, 7}, {80, 9}}});
  for (const std::vector<RingAxis>& axes : {crossed, overshot}) {
    const auto rings = network_rings(axes, {});
    ASSERT_EQ(rings.size(), 1u);
    EXPECT_EQ(rings[0].edges.size(), 4u);
    EXPECT_GT(rings[0].compactness, 0.97);
  }
  EXPECT_EQ(network_rings(crossed, {})[0].inside, 0);
  EXPECT_EQ(network_rings(overshot, {})[0].inside, 1);
}

// What leaves a ring across it leads to streets that an edit beside the ring does not look at.
TEST(NetworkRings, DoNotDependOnWhatIsFarAway) {
  std::vector<RingAxis> leaving = roundabout({0, 0}, 20, OneWay::no);
  leaving.push_back({9, {{20, 0}, {0, 7}, {-200, 9}}});
  EXPECT_TRUE(network_rings(leaving, {}).empty());
  std::vector<RingAxis> apart = leaving;
  apart.push_back({10, arc({-240, 9}, 40, 0, 180, 12)});
  apart.push_back({11, arc({-240, 9}, 40, 180, 360, 12)});
  ASSERT_EQ(network_rings(apart, {}).size(), 1u);
  EXPECT_LT(distance(network_rings(apart, {})[0].centre, {-240, 9, 0}), 1e-3);
  // Where the street ends within, the ring is one whatever lies around it.
  apart[5].line.pop_back();
  EXPECT_EQ(network_rings(apart, {}).size(), 2u);
}

// Over a motorway a ring has bridges; a street that passes from one of its nodes to another on a
// third level parts nothing either.
TEST(NetworkRings, LieOnSeveralLevels) {
  std::vector<RingAxis> axes{{1, arc({0, 0}, 40, -150, -30, 12), 0, OneWay::along},
                             {2, arc({0, 0}, 40, -30, 30, 12), 1, OneWay::along},
                             {3, arc({0, 0}, 40, 30, 150, 12), 0, OneWay::along},
                             {4, arc({0, 0}, 40, 150, 210, 12), 1, OneWay::along},
                             {5, {{-200, 3}, {200, 3}}, 0}};
  axes[1].line.front() = axes[0].line.back(), axes[1].line.back() = axes[2].line.front();
  axes[3].line.front() = axes[2].line.back(), axes[3].line.back() = axes[0].line.front();
  const auto rings = network_rings(axes, {});
  ASSERT_EQ(rings.size(), 1u);
  EXPECT_EQ(rings[0].edges.size(), 4u);
  EXPECT_NEAR(rings[0].one_way, 1, 1e-4);
  EXPECT_EQ(rings[0].level, 0);
  EXPECT_EQ(rings[0].inside, 0);
  std::vector<RingAxis> passed = roundabout({0, 0}, 20, OneWay::along);
  passed.push_back({9, {{-20, 0}, {20, 0}}, -1});
  const auto whole = network_rings(passed, {});
  ASSERT_EQ(whole.size(), 1u);
  EXPECT_EQ(whole[0].edges.size(), 4u);
}

TEST(NetworkRings, OfTwoFacesAreADoubleRoundabout) {
  const double half = 15 * std::sin(pi / 6);
  const Point upper{15 * std::cos(pi / 6), half}, lower{upper.x, -half};
  std::vector<RingAxis> axes{{1, arc({0, 0}, 15, 30, 330, 24)},
                             {2, arc({2 * upper.x, 0}, 15, 210, 510, 24)},
                             {3, {lower, upper}}};
  axes[0].line.front() = axes[1].line.back() = upper;
  axes[0].line.back() = axes[1].line.front() = lower;
  for (int a = 1; a < 4; ++a) axes.push_back(arm(10 + a, {0, 0}, 15, 90 * a));
  for (int a = 0; a < 4; a += 2) axes.push_back(arm(20 + a, {2 * upper.x, 0}, 15, 90 * a - 90));
  const auto rings = network_rings(axes, {});
  ASSERT_EQ(rings.size(), 1u);
  const NetworkRing& ring = rings[0];
  EXPECT_EQ(ring.faces.size(), 2u);
  EXPECT_EQ(ring.arm_nodes, 5);
  double within = 0;
  for (const Ring& face : ring.faces) within += signed_area(face);
  EXPECT_NEAR(signed_area(ring.line), within, 1e-6);
  EXPECT_LT(distance(ring.centre, {upper.x, 0, 0}), 1);
  // The piece between the faces is driven both ways, all else once.
  int of_piece = 0, last = 0;
  for (const RingEdge& edge : ring.edges) {
    of_piece += edge.axis_id == 3;
    EXPECT_GE(edge.face, last);
    last = edge.face;
  }
  EXPECT_EQ(of_piece, 2);
  EXPECT_EQ(last, 2);
  // Two that are wider together than half of the greatest circle are two rings.
  RingSettings narrow;
  narrow.radius_greatest = 50;
  EXPECT_EQ(network_rings(axes, narrow).size(), 2u);
  // A block beside a ring is no half of it.
  std::vector<RingAxis> block = roundabout({0, 0}, 20, OneWay::no);
  block.push_back({9, {{80, 0}, {80, 80}, {0, 80}}});
  for (const NetworkRing& one : network_rings(block, {})) EXPECT_EQ(one.faces.size(), 1u);
  // Nor are three in a row a double one: each stays as it is.
  axes.push_back({4, arc({4 * upper.x, 0}, 15, 210, 510, 24)});
  axes.back().line.front() = {3 * upper.x, -half};
  axes.back().line.back() = {3 * upper.x, half};
  axes[1].line = arc({2 * upper.x, 0}, 15, 210, 330, 12);
  axes[1].line.front() = lower, axes[1].line.back() = {3 * upper.x, -half};
  axes.push_back({5, arc({2 * upper.x, 0}, 15, 30, 150, 12)});
  axes.back().line.front() = {3 * upper.x, half}, axes.back().line.back() = upper;
  axes.push_back({6, {{3 * upper.x, -half}, {3 * upper.x, half}}});
  for (const NetworkRing& one : network_rings(axes, {})) EXPECT_EQ(one.faces.size(), 1u);
  EXPECT_EQ(network_rings(axes, {}).size(), 3u);
}

TEST(NetworkRings, WithAWaistAreAsRoundAsTheirHalves) {
  Line peanut = arc({0, 0}, 14, 45, 315, 24);
  for (const Point& p : arc({30, 0}, 14, 225, 495, 24)) peanut.push_back(p);
  peanut.push_back(peanut.front());
  const auto rings = network_rings({{1, peanut}}, {});
  ASSERT_EQ(rings.size(), 1u);
  EXPECT_GT(rings[0].compactness, 0.88);
  EXPECT_TRUE(rings[0].waist);
  EXPECT_EQ(rings[0].faces.size(), 1u);
  // Neither a street twice as long as wide nor a square has one.
  Line oval = arc({0, 0}, 14, 90, 270, 24);
  for (const Point& p : arc({28, 0}, 14, -90, 90, 24)) oval.push_back(p);
  oval.push_back(oval.front());
  for (const Line& line : {oval, Line{{0, 0}, {28, 0}, {28, 28}, {0, 28}, {0, 0}}}) {
    EXPECT_LT(network_rings({{1, line}}, {}).at(0).compactness, 0.86);
    EXPECT_FALSE(network_rings({{1, line}}, {}).at(0).waist);
  }
}

// What cannot be drawn as one way round is none.
TEST(NetworkRings, ThatCrossThemselvesAreNone) {
  Line eight = arc({0, 0}, 20, 45, 315, 24);
  for (const Point& p : reversed(arc({40, 0}, 20, -135, 135, 24))) eight.push_back(p);
  eight.push_back(eight.front());
  EXPECT_TRUE(network_rings({{1, eight}}, {}).empty());
  EXPECT_TRUE(network_rings({{1, {{0, 0}, {30, 0}, {0, 0}}}}, {}).empty());
  EXPECT_EQ(network_rings({{1, {{0, 0}, {30, 0}, {15, 26}, {0, 0}}}}, {}).size(), 1u);
  EXPECT_EQ(network_rings({{1, circle({0, 0}, 20, 1000)}}, {}).size(), 1u);
}

// An egg whose line begins at one place or another, and is drawn one way or the other.
TEST(NetworkRings, HaveOneCircleWhereverTheirLineBegins) {
  Line egg = arc({0, 0}, 14.3, 80, 280, 11);
  for (const Point& p : arc({4, 0.5}, 13.1, -77, 76, 7)) egg.push_back(p);
  const auto ring_from = [&](std::size_t begin, bool backwards) {
    Line line = egg;
    std::rotate(line.begin(), line.begin() + begin, line.end());
    line.push_back(line.front());
    return network_rings({{1, backwards ? reversed(line) : line}}, {}).at(0);
  };
  const NetworkRing ring = ring_from(0, false);
  for (std::size_t begin = 0; begin < egg.size(); ++begin)
    for (const bool backwards : {false, true}) {
      const NetworkRing other = ring_from(begin, backwards);
      EXPECT_NEAR(other.radius, ring.radius, 1e-9);
      EXPECT_LT(distance(other.centre, ring.centre), 1e-9);
      EXPECT_EQ(other.on_circle, ring.on_circle);
    }
}

// A ring drawn as a regular polygon, and one with a corner aside by ten micrometres.
TEST(NetworkRings, OfARegularPolygonItHasTheRadiusThatItHasBesideIt) {
  const auto radius = [](double aside) {
    Line ring;
    for (int k = 0; k < 8; ++k)
      ring.push_back({(10 + (k == 0 ? aside : 0)) * std::cos(k * M_PI / 4),
                      10 * std::sin(k * M_PI / 4)});
    ring.push_back(ring.front());
    return network_rings({{1, ring}}, {}).at(0).radius;
  };
  EXPECT_NEAR(radius(0), radius(1e-5), 0.05);
}

// An egg whose two ends are as far from its middle: the circle lies on the line between them.
TEST(NetworkRings, OfASymmetricalLineHaveASymmetricalCircle) {
  Line egg = arc({0, 0}, 14.3, 80, 280, 11);
  for (const Point& p : arc({1, 0}, 13.1, -77, 77, 8)) egg.push_back(p);
  egg.push_back(egg.front());
  const auto rings = network_rings({{1, egg}}, {});
  ASSERT_EQ(rings.size(), 1u);
  EXPECT_NEAR(rings[0].centre.y, 0, 1e-9);
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

}  // namespace network_rings_test
}  // namespace streetgen
