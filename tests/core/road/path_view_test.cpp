#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "geometry/polyline.hpp"
#include "random_line.hpp"
#include "smooth_chain.hpp"
#include "streetgen/plan_view.hpp"

namespace streetgen {
namespace path_view_test {

// The place ahead lies straight on, but is left in another direction.
TEST(PathView, SetsOutAsAskedWhereOnlyTheEndTurns) {
  for (const double heading_to : {-0.5, 0.0, 0.2, 3.0}) {
    const auto chain = path_view({{0, 0}, {3, 0}}, {{0, 0}, 0}, {{3, 0}, heading_to}, 1, 3.5);
    expect_smooth(chain);
    EXPECT_LT(turn_between(chain.front().start.heading, 0), 1e-9);
    EXPECT_LT(turn_between(place_at(chain, length(chain)).heading, heading_to), 1e-6);
  }
}

TEST(PathView, JoinsTwoPlaces) {
  std::mt19937 random(22);
  std::uniform_real_distribution<double> beside(-0.3, 0.3);
  for (int i = 0; i < 100; ++i) {
    const Line line = random_line(random, {3, 1.5});
    const auto near = [&](const Point& p) {
      return ChainPlace{planar(p) + Point{beside(random), beside(random)}, beside(random)};
    };
    const ChainPlace from = near(line.front()), to = near(line.back());
    const auto chain = path_view(line, from, to, 0.05, 3.5);
    expect_smooth(chain);
    const ChainPlace end = place_at(chain, length(chain));
    EXPECT_LT(distance(end.point, to.point), 1e-6);
    EXPECT_LT(turn_between(end.heading, to.heading), 1e-6);
    EXPECT_LT(distance(chain.front().start.point, from.point), 1e-9);
  }
}

// A turn as paths have it: a way in, an arc of points a metre or less apart, and a way out.
Line turning(double in, double radius, double turn, double out) {
  Line line{{0, 0}};
  const double side = turn < 0 ? -1 : 1;
  const int steps = std::max(4, static_cast<int>(std::ceil(radius * std::abs(turn))));
  for (int i = 0; i <= steps; ++i) {
    const double a = std::abs(turn) * i / steps;
    line.push_back({in + radius * std::sin(a), side * radius * (1 - std::cos(a))});
  }
  line.push_back(line.back() + Point{std::cos(turn), std::sin(turn)} * out);
  return line;
}

// One arc between two lines, however sharp the turn: as few pieces as a road engineer would draw.
TEST(PathView, OfATurnIsAnArcBetweenLines) {
  std::mt19937 random(23);
  std::uniform_real_distribution<double> ways(0.2, 12), radii(2.5, 20), turns(0.3, 2.2);
  for (int i = 0; i < 200; ++i) {
    const double radius = radii(random), turn = (i % 2 == 0 ? 1 : -1) * turns(random);
    const Line line = turning(ways(random), radius, turn, ways(random));
    const auto chain = path_view(line, {line.front(), 0}, {line.back(), turn}, 0.05, 3.5);
    expect_smooth(chain);
    expect_within(chain, line, 0.1);
    EXPECT_LE(chain.size(), 3u) << i;
    for (const PlanPiece& piece : chain)
      EXPECT_LE(std::abs(piece.curvature), 1 / (radius - 1)) << i;
  }
}

// A path that turns on the corner of its ends has an arc there, and no kink.
TEST(PathView, RoundsACorner) {
  for (const double turn : {0.4, 1.2, -1.5}) {
    const Point out = Point{5, 0} + Point{std::cos(turn), std::sin(turn)} * 5;
    const auto chain = path_view({{0, 0}, {5, 0}, out}, {{0, 0}, 0}, {out, turn}, 0.05, 3.5);
    ASSERT_GT(chain.size(), 1u);
    expect_smooth(chain);
    EXPECT_LT(turn_between(place_at(chain, length(chain)).heading, turn), 1e-6);
  }
  // The end lies on the corner itself, and leads elsewhere.
  const auto ended = path_view({{0, 0}, {5, 0}}, {{0, 0}, 0}, {{5, 1e-9}, 0.4}, 0.05, 3.5);
  expect_smooth(ended);
}

// A parabola as the model draws its ways, from one lane to another.
Line parabola(const Point& control, const Point& end) {
  Line line;
  for (int i = 0; i <= 8; ++i) {
    const double t = i / 8.0;
    line.push_back(control * (2 * t * (1 - t)) + end * (t * t));
  }
  return line;
}

double sharpest(const std::vector<PlanPiece>& chain) {
  double most = 0;
  for (const PlanPiece& piece : chain) most = std::max(most, std::abs(piece.curvature));
  return most;
}

TEST(PathView, HasFewPiecesOfAParabola) {
  std::mt19937 random(24);
  std::uniform_real_distribution<double> legs(6, 15), turns(0.8, 2);
  double pieces = 0;
  for (int i = 0; i < 200; ++i) {
    const double turn = (i % 2 == 0 ? 1 : -1) * turns(random);
    const Point corner{legs(random), 0};
    const Line line =
        parabola(corner, corner + Point{std::cos(turn), std::sin(turn)} * legs(random));
    const auto chain = path_view(line, {line.front(), 0}, {line.back(), turn}, 0.05, 3.5);
    expect_smooth(chain);
    EXPECT_LT(distance(place_at(chain, length(chain)).point, line.back()), 1e-6);
    EXPECT_LT(turn_between(place_at(chain, length(chain)).heading, turn), 1e-6);
    pieces += chain.size();
  }
  EXPECT_LE(pieces / 200, 3);
}

// A lane leads elsewhere than the path: the curve needs room beside that end, and there alone.
TEST(PathView, IsAsWideAsAnyCurveWhereItsEndsLeadElsewhere) {
  for (const double kink : {0.1, 0.3, 0.5, -0.7})
    for (const double width : {3.0, 3.5, 8.0}) {
      const Line line{{0, 0}, {30, 0}};
      const auto chain = path_view(line, {line[0], kink}, {line[1], 0}, 0.05, width);
      expect_smooth(chain);
      const double radius = std::max(least_curve_radius, width / 2);
      EXPECT_LE(sharpest(chain), 1.03 / radius);
      EXPECT_LE(chain.size(), 6u);
      for (const Point& p : places(chain)) {
        EXPECT_LE(std::abs(p.y), 0.1 + 2 * radius * (1 - std::cos(kink)));
        if (p.x > 12) EXPECT_LE(std::abs(p.y), 0.1);
      }
    }
}

// Two ways that meet across a lane of a centimetre, as at nodes whose limits cross.
TEST(PathView, LeadsOverAJointWithoutASharpBend) {
  const Line line{{0, 0}, {15, 0}, {15.007, 0.007}, {30, 4}};
  const double end = std::atan2(3.993, 14.993);
  const auto chain = path_view(line, {line.front(), 0}, {line.back(), end}, 0.05, 3.5);
  expect_smooth(chain);
  expect_within(chain, line, 0.15);
  EXPECT_LE(sharpest(chain), 1.002 / least_curve_radius);
}

// A path that turns sharper itself is followed.
TEST(PathView, TurnsBackAsItsPathDoes) {
  const Line line = turning(2, 1.5, 2.9, 2);
  const auto chain = path_view(line, {line.front(), 0}, {line.back(), 2.9}, 0.05, 3.5);
  expect_smooth(chain);
  expect_within(chain, line, 0.1);
}

TEST(PathView, HasNoPieceWithoutALength) {
  EXPECT_TRUE(path_view({{0, 0}, {1, 0}}, {{2, 2}, 0}, {{2, 2}, 1}, 0.05, 3.5).empty());
}

}  // namespace path_view_test
}  // namespace streetgen
