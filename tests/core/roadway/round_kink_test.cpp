#include "roadway/round_kink.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {
namespace round_kink_test {

double turn_at(const Point& before, const Point& at, const Point& after) {
  const Point in = at - before, out = after - at;
  return std::abs(std::atan2(cross(in, out), dot(in, out)));
}

double widest_turn(const Line& line) {
  double widest = 0;
  for (std::size_t i = 1; i + 1 < line.size(); ++i)
    widest = std::max(widest, turn_at(line[i - 1], line[i], line[i + 1]));
  return widest;
}

constexpr double chord = M_PI_2 / 8;  // turn of an arc at a vertex, radians, at most

TEST(RoundKink, IsTheArcThatTouchesBothSides) {
  const Line round = with_round_kinks({{0, 0}, {10, 0}, {10, 10}}, 2, {});
  EXPECT_TRUE(same(round.front(), Point{0, 0}));
  EXPECT_TRUE(same(round.back(), Point{10, 10}));
  for (std::size_t i = 1; i + 1 < round.size(); ++i)
    EXPECT_NEAR(distance(round[i], {8, 2}), 2, 1e-12);
  EXPECT_LE(widest_turn(round), chord + 1e-9);
}

TEST(RoundKink, LeavesSlightTurnsAndTheRadiusOfZero) {
  const Line slight{{0, 0}, {10, 0}, {20, 5}}, right_angle{{0, 0}, {10, 0}, {10, 10}};
  EXPECT_TRUE(same(with_round_kinks(slight, 1, {}), slight));
  EXPECT_TRUE(same(with_round_kinks(right_angle, 0, {}), right_angle));
}

TEST(RoundKink, SharesASideBetweenTwo) {
  const Line round = with_round_kinks({{0, 0}, {10, 0}, {10, 1}, {20, 1}}, 5, {});
  EXPECT_LE(widest_turn(round), chord + 1e-9);
  for (const Point& p : round) {
    EXPECT_GE(p.y, 0);
    EXPECT_LE(p.y, 1);
  }
}

TEST(RoundKink, StaysClearOfBorders) {
  const Line sharp{{0, 0}, {10, 0}, {10, 10}}, border{{9, 0}, {9, 5}};
  for (const Point& p : with_round_kinks(sharp, 20, {border}))
    EXPECT_TRUE(distance(p, {10, 0}) < 1 || same(p, sharp.front()) || same(p, sharp.back()));
  EXPECT_TRUE(same(with_round_kinks(sharp, 2, {{{10, 0}, {10, -5}}}), sharp));
}

TEST(RoundKink, StaysClearOfTheOtherRings) {
  Geos geos;
  const Ring hole{{9.7, 0.3}, {9.5, 0.3}, {9.7, 0.5}, {9.7, 0.3}};
  MultiPolygon surface{{{{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}}, hole}};
  round_kinks(geos, surface, 3, {});
  const double off = distance({10, 0}, hole.front());
  for (const Point& p : surface.front().front())
    EXPECT_TRUE(p.x < 10 - off / 2 || p.y > 0 || distance(p, {10, 0}) < off);
  EXPECT_TRUE(inside({9.65, 0.31}, {surface.front().front()}));
}

std::vector<StreetAxis> bent_street() {
  return {{1, {{0, 0, 0}, {40, 0, 0}, {60, 40, 0}}, 0, 8, 8, 4, 3}};
}

double sharpest(const MultiPolygon& surface) {
  double widest = 0;
  for (const Polygon& polygon : surface)
    for (const Ring& ring : polygon)
      for (std::size_t i = 1; i + 1 < ring.size(); ++i)
        if (distance(ring[i], {40, 0, 0}) < 10)
          widest = std::max(widest, turn_at(ring[i - 1], ring[i], ring[i + 1]));
  return widest;
}

TEST(RoundKink, OfAStreetIsTheInsideOfItsBend) {
  StreetSettings settings;
  const Streets round = streets(bent_street(), settings);
  settings.kerb_radius_minimal = 0;
  const Streets sharp = streets(bent_street(), settings);
  EXPECT_GT(sharpest(sharp.sections.front().surface), 1);
  EXPECT_LE(sharpest(round.sections.front().surface), chord + 1e-9);
  // The tip of the bend between the arc and its tangents.
  const double turn = std::atan2(40, 20), radius = 0.5;
  const double tip = radius * radius * (std::tan(turn / 2) - turn / 2);
  const double gained = area(round.sections.front().surface) - area(sharp.sections.front().surface);
  EXPECT_NEAR(gained, tip, 0.05 * tip);
}

TEST(RoundKink, LeavesCornersWantedWithoutAnArc) {
  const std::vector<StreetAxis> crossing{{1, {{-50, 0, 0}, {50, 0, 0}}, 0, 8, 8, 0, 3},
                                         {2, {{0, -50, 0}, {0, 50, 0}}, 0, 6, 6, 0, 3}};
  StreetSettings settings;
  settings.crossing = Crossing::split;
  const Streets town = streets(crossing, settings);
  ASSERT_EQ(town.intersections.size(), 1u);
  const Ring& ring = town.intersections.front().surface.front().front();
  for (const Point& corner : {Point{3, 4}, Point{-3, 4}, Point{-3, -4}, Point{3, -4}})
    EXPECT_TRUE(std::any_of(ring.begin(), ring.end(),
                            [&](const Point& p) { return distance(p, corner) < 1e-9; }));
}

}  // namespace round_kink_test
}  // namespace streetgen
