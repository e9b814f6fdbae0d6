#include "streetgen/detect_arcs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/polyline.hpp"
#include "rounds.hpp"

namespace streetgen {
namespace detect_arcs_test {

constexpr double pi = 3.14159265358979323846;

struct Drawn {
  Line line;
  Point centre;
  double radius = 0, turn = 0;  // degrees
};

double between(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

// Points at most 45 degrees apart about the centre, each moved by at most `noise`.
Drawn random_arc(std::mt19937_64& random, double noise) {
  Drawn drawn;
  drawn.centre = {between(random, 0, 1000), between(random, 0, 1000), 0};
  drawn.turn = between(random, 20, 360);
  const double turn = drawn.turn * pi / 180, start = between(random, 0, 2 * pi);
  const double spacing = between(random, 0.5, 3);
  // Four points and more, and no arc that noise alone could make.
  drawn.radius = between(random,
                         std::max({2.0, spacing / (pi / 4), 3 * spacing / turn,
                                   20 * noise / (1 - std::cos(turn / 2))}),
                         80);
  const int sides = std::max(3, static_cast<int>(std::ceil(turn * drawn.radius / spacing)));
  const double way = random() % 2 == 0 ? 1 : -1;
  for (int i = 0; i <= sides; ++i) {
    const double at = start + way * turn * i / sides;
    drawn.line.push_back(drawn.centre + Point{std::cos(at), std::sin(at), 0} * drawn.radius +
                         Point{between(random, -noise, noise), between(random, -noise, noise), 0});
  }
  return drawn;
}

Line random_blocks(std::mt19937_64& random) {
  Line line{{between(random, 0, 1000), between(random, 0, 1000), 0}};
  double heading = between(random, 0, 2 * pi);
  const int blocks = 2 + random() % 12;
  for (int i = 0; i < blocks; ++i) {
    const double size = between(random, 20, 150);
    const int pieces = 1 + random() % 10;
    const Point from = line.back();
    for (int k = 1; k <= pieces; ++k)
      line.push_back(from + Point{std::cos(heading), std::sin(heading), 0} * (size * k / pieces));
    heading += between(random, -2 * pi / 3, 2 * pi / 3);
  }
  return line;
}

TEST(DetectArcs, FindsRandomArcs) {
  std::mt19937_64 random(1);
  ArcBounds bounds;
  bounds.turn_least = 15;
  const int tries = rounds(10000);
  int found = 0, sharp = 0, near = 0;
  for (int i = 0; i < tries; ++i) {
    const Drawn drawn = random_arc(random, bounds.tolerance / 10);
    const auto arcs = detect_arcs(drawn.line, bounds);
    const bool hit = arcs.size() == 1 && 2 * arcs[0].support > static_cast<int>(drawn.line.size());
    found += hit;
    if (drawn.turn <= 60) continue;
    ++sharp;
    near += hit && std::abs(arcs[0].radius - drawn.radius) <= 0.02 * drawn.radius;
  }
  EXPECT_GE(found, 0.99 * tries);
  EXPECT_GE(near, 0.99 * sharp);
}

TEST(DetectArcs, FindsNoneInStraightBlocks) {
  std::mt19937_64 random(2);
  int found = 0;
  for (int i = 0; i < rounds(10000); ++i) found += !detect_arcs(random_blocks(random), {}).empty();
  EXPECT_EQ(found, 0);
}

TEST(DetectArcs, ClosesACircleWhereverItStarts) {
  Line circle;
  for (int i = 0; i <= 24; ++i)
    circle.push_back({500 + 15 * std::cos(i * pi / 12), 700 + 15 * std::sin(i * pi / 12), 0});
  circle.back() = circle.front();
  const auto arcs = detect_arcs(circle, {});
  ASSERT_EQ(arcs.size(), 1u);
  EXPECT_NEAR(arcs[0].radius, 15, 1e-6);
  EXPECT_LT(distance(arcs[0].centre, {500, 700, 0}), 1e-6);
  EXPECT_LT(distance(arcs[0].arc.start, arcs[0].arc.end), 1e-9);
  EXPECT_NEAR(distance(arcs[0].arc.start, arcs[0].arc.middle), 30, 1e-6);
  EXPECT_EQ(arcs[0].support, 24);
}

TEST(DetectArcs, TellsTwoArcsApart) {
  Line line;
  for (int i = 0; i <= 12; ++i)
    line.push_back({20 * std::sin(i * pi / 24), 20 - 20 * std::cos(i * pi / 24), 0});
  for (int i = 1; i <= 12; ++i)
    line.push_back({60 - 40 * std::cos(i * pi / 24), 20 + 40 * std::sin(i * pi / 24), 0});
  const auto arcs = detect_arcs(line, {});
  ASSERT_EQ(arcs.size(), 2u);
  EXPECT_NEAR(arcs[0].radius, 20, 0.4);
  EXPECT_NEAR(arcs[1].radius, 40, 0.8);
}

TEST(DetectArcs, HasNoneWithoutFourPoints) {
  EXPECT_TRUE(detect_arcs({}, {}).empty());
  EXPECT_TRUE(detect_arcs({{0, 0}, {1, 1}, {1, 1}, {2, 0}}, {}).empty());
  EXPECT_TRUE(detect_arcs({{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}}, {}).empty());
}

// The straight lines before and behind the arc come within the tolerance of its circle.
TEST(DetectArcs, LeavesTheTangentsOfAKerbAway) {
  for (const double turn : {50.0, 70.0, 90.0, 120.0}) {
    const double angle = turn * pi / 180, radius = 3;
    Line kerb{{-8, 0, 0}, {-0.5, 0, 0}};
    const int chords = static_cast<int>(turn / 12);
    for (int i = 0; i <= chords; ++i) {
      const double at = angle * i / chords;
      kerb.push_back({radius * std::sin(at), radius * (1 - std::cos(at)), 0});
    }
    const Point end = kerb.back(), along = {std::cos(angle), std::sin(angle), 0};
    kerb.push_back(end + along * 0.5);
    kerb.push_back(end + along * 8);
    ArcBounds bounds;
    bounds.tolerance = 0.05;
    const std::vector<DetectedArc> arcs = detect_arcs(kerb, bounds);
    ASSERT_EQ(arcs.size(), 1u);
    EXPECT_NEAR(arcs[0].radius, radius, 0.01);
  }
}

// Points of a kerb about a corner, half a metre apart, with normal noise of 5 cm.
Line noisy_kerb(std::mt19937_64& random, double turn, double radius) {
  std::normal_distribution<double> noise(0, 0.05);
  const double angle = turn * pi / 180;
  const Point end{radius * std::sin(angle), radius * (1 - std::cos(angle)), 0};
  const Point along{std::cos(angle), std::sin(angle), 0};
  Line kerb;
  for (double at = -20; at < angle * radius + 20; at += 0.5) {
    const Point on_kerb = at < 0                ? Point{at, 0, 0}
                          : at < angle * radius ? Point{radius * std::sin(at / radius),
                                                        radius * (1 - std::cos(at / radius)), 0}
                                                : end + along * (at - angle * radius);
    kerb.push_back(on_kerb + Point{noise(random), noise(random), 0});
  }
  return kerb;
}

TEST(DetectArcs, FindsTheCornersOfNoisyKerbs) {
  std::mt19937_64 random(7);
  ArcBounds bounds;
  bounds.tolerance = 0.2;
  int found = 0;
  constexpr int kerbs = 300;
  for (int i = 0; i < kerbs; ++i) {
    const double radius = between(random, 3, 12);
    for (const DetectedArc& arc :
         detect_arcs(noisy_kerb(random, between(random, 60, 120), radius), bounds))
      if (std::abs(arc.radius / radius - 1) < 0.15) {
        ++found;
        break;
      }
  }
  EXPECT_GE(found, 0.95 * kerbs);
}

}  // namespace detect_arcs_test
}  // namespace streetgen
