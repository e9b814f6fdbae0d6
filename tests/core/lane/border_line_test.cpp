#include "streetgen/border_line.hpp"

#include "geometry/polyline.hpp"
#include "lane/bound_side.hpp"

namespace streetgen {
namespace {

constexpr double tolerance = 0.05;

// Straight on, an arc to the left (to the right: negative), and straight on.
std::vector<PlanPiece> turn(double before, double radius, double angle, double behind) {
  std::vector<PlanPiece> chain;
  ChainPlace place;
  const auto add = [&](double length, double curvature) {
    if (length <= 0) return;
    PlanPiece piece{chain.empty() ? 0 : chain.back().s + chain.back().length, place, length,
                    curvature, curvature};
    chain.push_back(piece);
    place = place_at(chain, piece.s + length);
  };
  add(before, 0);
  add(radius * std::abs(angle), (angle > 0 ? 1 : -1) / radius);
  add(behind, 0);
  return chain;
}

// The two bounds of a lane about its middle.
BorderCourse lane(std::vector<PlanPiece> chain, double width) {
  BorderCourse course;
  course.stations = {0, length(chain)};
  course.borders = {{width / 2, width / 2}, {-width / 2, -width / 2}};
  course.chain = std::move(chain);
  return course;
}

int crossings_of(const Line& a, const Line& b) {
  int count = 0;
  for (std::size_t i = 1; i < a.size(); ++i)
    for (std::size_t k = 1; k < b.size(); ++k)
      if ((&a != &b || k > i + 1) && crossing(a[i - 1], a[i], b[k - 1], b[k])) ++count;
  return count;
}

double nearest_to(const Line& line, const Line& other) {
  double least = 1e9;
  for (const Point& p : line) least = std::min(least, distance_to_line(p, other));
  return least;
}

TEST(BorderLine, AStraightLaneHasFourPoints) {
  const auto lines = border_lines(lane(turn(30, 1, 0, 0), 3), {}, tolerance);
  ASSERT_EQ(lines.size(), 2u);
  for (const Line& line : lines) EXPECT_EQ(line.size(), 2u);
  EXPECT_TRUE(are_bounds(lines[0], lines[1]));
}

TEST(BorderLine, ABendTighterThanTheLaneCutsItsInnerBorder) {
  for (const double angle : {0.6, 1.5, 2.5, -0.6, -1.5, -2.5}) {
    const auto lines = border_lines(lane(turn(12, 0.4, angle, 12), 3.5), {}, tolerance);
    EXPECT_EQ(crossings_of(lines[0], lines[0]) + crossings_of(lines[1], lines[1]), 0) << angle;
    EXPECT_EQ(crossings_of(lines[0], lines[1]), 0) << angle;
    EXPECT_TRUE(are_bounds(lines[0], lines[1])) << angle;
    EXPECT_GT(nearest_to(lines[0], lines[1]), 3.5 - 2 * tolerance) << angle;
    const Line& inner = lines[angle > 0 ? 0 : 1];
    EXPECT_EQ(inner.size(), 3u) << angle;
  }
}

TEST(BorderLine, ABorderBeginsAndEndsWhereItIsTold) {
  const std::vector<BorderEnds> ends{{{0, 2}, {5.9, 8}}, {{0, -2}, {10.1, 8}}};
  const auto lines = border_lines(lane(turn(6, 2, M_PI_2, 6), 4), ends, tolerance);
  for (std::size_t b = 0; b < 2; ++b) {
    EXPECT_TRUE(same(lines[b].front(), ends[b].from));
    EXPECT_TRUE(same(lines[b].back(), ends[b].to));
  }
  EXPECT_TRUE(are_bounds(lines[0], lines[1]));
}

// At an end there is no other side of the loop to cut.
TEST(BorderLine, ABendAtAnEndLeadsNeverBack) {
  for (const double angle : {1.2, -1.2})
    for (const bool at_start : {true, false}) {
      const auto chain = at_start ? turn(0, 0.5, angle, 15) : turn(15, 0.5, angle, 0);
      const auto lines = border_lines(lane(chain, 3.5), {}, tolerance);
      EXPECT_EQ(crossings_of(lines[0], lines[1]), 0);
      EXPECT_TRUE(are_bounds(lines[0], lines[1]));
    }
}

TEST(BorderLine, WhoTurnsBackIntoTheNextLaneGoesRoundANose) {
  for (const double turned : {M_PI, -M_PI, 4.2, -4.2}) {
    const auto lines = border_lines(lane(turn(0, 1.5, turned, 0), 3.5), {}, tolerance);
    EXPECT_TRUE(are_bounds(lines[0], lines[1])) << turned;
    const Line& inner = lines[turned > 0 ? 0 : 1];
    for (std::size_t i = 1; i < inner.size(); ++i)
      EXPECT_GT(distance(inner[i - 1], inner[i]), 0.05);
  }
}

TEST(BorderLine, ARampThatPassesOverItselfStaysWhole) {
  const auto chain = turn(60, 15, 1.5 * M_PI, 60);
  const auto lines = border_lines(lane(chain, 3.5), {}, tolerance);
  EXPECT_NEAR(length(lines[0]), 120 + 1.5 * M_PI * (15 - 1.75), 0.5);
  EXPECT_NEAR(length(lines[1]), 120 + 1.5 * M_PI * (15 + 1.75), 0.5);
}

TEST(BorderLine, HeightsKeepTheirCrest) {
  BorderCourse course = lane(turn(100, 1, 0, 0), 3);
  course.height_stations = {0, 50, 100};
  course.heights = {10, 12, 10};
  for (const Line& line : border_lines(course, {}, tolerance)) {
    ASSERT_EQ(line.size(), 3u);
    EXPECT_NEAR(line[1].z, 12, 1e-9);
    EXPECT_NEAR(line[0].z, 10, 1e-9);
  }
}

TEST(BoundSide, AReaderTurnsWhatLiesOnTheWrongSide) {
  const Line left{{0, 3}, {10, 3}}, right{{0, 0}, {10, 0}};
  EXPECT_TRUE(are_bounds(left, right));
  EXPECT_FALSE(are_bounds(right, left));
  EXPECT_FALSE(are_bounds(left, reversed(right)));
  EXPECT_TRUE(are_bounds(reversed(right), reversed(left)));
}

}  // namespace
}  // namespace streetgen
