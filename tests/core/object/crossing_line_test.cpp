#include "streetgen/crossing_line.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/polyline.hpp"

namespace streetgen {
namespace crossing_line_test {

// 2 m to the right of the x axis, from 10 to 90 m, and 3 m wide.
const DrivenLane along{{{10, -2, 0}, {90, -2, 0}}, 3, false};
const PaintOnLane line{{{89.75, -3.5, 0}, {89.75, -0.5, 0}}};
const PaintOnLane arrow{{{81, -2, 0}, {85, -2, 0}}, true};

Point moved(const Slide& slide, const Point& p) {
  return Point{slide.cosine * p.x - slide.sine * p.y, slide.sine * p.x + slide.cosine * p.y} +
         slide.shift;
}

// Of a street along the x axis, 8 m wide; `slope`: metres farther for each metre to its left.
struct EdgeCrossing {
  double abscissa, width, slope;
};

MultiPolygon ground(const EdgeCrossing& crossing) {
  const auto at = [&](double along, double beside) {
    return Point{crossing.abscissa + along * crossing.width / 2 + crossing.slope * beside, beside};
  };
  return {{{at(-1, -4), at(1, -4), at(1, 4), at(-1, 4), at(-1, -4)}}};
}

// The place along the x axis of the last point, once laid; none where there is no room.
std::optional<double> laid(const DrivenLane& lane, const std::vector<EdgeCrossing>& crossings,
                           const PaintOnLane& paint) {
  std::vector<MultiPolygon> grounds;
  for (const EdgeCrossing& crossing : crossings) grounds.push_back(ground(crossing));
  const std::vector<LaidPaint> all = lay_before_crossings(lane, grounds, {paint}, {});
  if (!all[0].has_room) return std::nullopt;
  return all[0].slide ? moved(*all[0].slide, paint.line.back()).x : paint.line.back().x;
}

TEST(CrossingLine, LiesAMetreBeforeTheCrossing) {
  EXPECT_DOUBLE_EQ(*laid(along, {}, line), 89.75);
  EXPECT_NEAR(*laid(along, {{86, 4, 0}}, line), 84 - 1 - 0.25, 1e-9);
  EXPECT_NEAR(*laid(along, {{95, 4, 0}}, line), 89.75, 1e-9) << "behind the line";
  EXPECT_NEAR(*laid(along, {{70, 4, 0}}, line), 89.75, 1e-9) << "18 m before the end";
  EXPECT_NEAR(*laid(along, {{75, 4, 0}}, line), 73 - 1.25, 1e-9) << "13 m before the end";
}

TEST(CrossingLine, LiesBeforeTheOneThatTheDriverMeetsFirst) {
  EXPECT_NEAR(*laid(along, {{86, 4, 0}, {78, 4, 0}}, line), 76 - 1.25, 1e-9);
  EXPECT_NEAR(*laid(along, {{78, 4, 0}, {70, 4, 0}}, line), 68 - 1.25, 1e-9)
      << "no car has room between";
  EXPECT_NEAR(*laid(along, {{86, 4, 0}, {70, 4, 0}}, line), 84 - 1.25, 1e-9)
      << "18 m before the end";
}

// 2 m to the right of the axis, 3 m wide.
TEST(CrossingLine, KnowsHowACrossingGoesAslant) {
  EXPECT_NEAR(*laid(along, {{86, 4, 1}}, line), 86 - 2 - 2 - 1.5 - 1.25, 1e-9);
  EXPECT_NEAR(*laid(along, {{86, 4, -1}}, line), 86 + 2 - 2 - 1.5 - 1.25, 1e-9);
}

TEST(CrossingLine, LeavesACrossingToTheJunctionBehind) {
  DrivenLane lane = along;
  lane.way = {{60, -2, 0}, {78, -2, 0}};
  const PaintOnLane end{{{77.75, -3.5, 0}, {77.75, -0.5, 0}}};
  EXPECT_NEAR(*laid(lane, {{64, 4, 0}}, end), 62 - 1.25, 1e-9);
  lane.between_junctions = true;
  EXPECT_NEAR(*laid(lane, {{64, 4, 0}}, end), 77.75, 1e-9);
  EXPECT_NEAR(*laid(lane, {{64, 4, 0}, {75, 4, 0}}, end), 73 - 1.25, 1e-9);
  EXPECT_NEAR(*laid(lane, {{66, 4, 0}, {71, 4, 0}}, end), 64 - 1.25, 1e-9)
      << "a line has no room between";
  lane.way = {{60, -2, 0}, {70, -2, 0}};
  EXPECT_NEAR(*laid(lane, {{64, 4, 0}}, {{{69.75, -3.5, 0}, {69.75, -0.5, 0}}}), 62 - 1.25, 1e-9)
      << "no car has room behind it";
}

TEST(CrossingLine, IsNotPaintedWhereTheCrossingLeavesNoRoom) {
  DrivenLane lane = along;
  lane.way = {{84.4, -2, 0}, {90, -2, 0}};
  EXPECT_FALSE(laid(lane, {{86, 4, 0}}, line));
  lane.way = {{83, -2, 0}, {90, -2, 0}};
  EXPECT_NEAR(*laid(lane, {{86, 4, 0}}, line), 83.25, 1e-9) << "less than a metre before it";
}

TEST(CrossingLine, StaysBeforeARing) {
  EXPECT_DOUBLE_EQ(*laid(along, {{86, 4, 0}}, {line.line, false, true}), 89.75);
}

TEST(CrossingLine, ArrowsLieOnNoCrossing) {
  EXPECT_DOUBLE_EQ(*laid(along, {{88, 2, 0}}, arrow), 85);
  EXPECT_NEAR(*laid(along, {{84, 4, 0}}, arrow), 82 - 1, 1e-9);
  EXPECT_NEAR(*laid(along, {{84, 4, 0}, {70, 4, 0}}, arrow), 81, 1e-9) << "between two";
  EXPECT_NEAR(*laid(along, {{88, 2, 0}, {70, 4, 0}}, {{{70, -2, 0}, {74, -2, 0}}, true}), 67, 1e-9)
      << "before one in the middle of its block";
  DrivenLane lane = along;
  lane.way = {{80, -2, 0}, {90, -2, 0}};
  EXPECT_FALSE(laid(lane, {{84, 4, 0}}, arrow));
}

TEST(CrossingLine, ArrowsLieBeforeTheLine) {
  const auto all = lay_before_crossings(along, {ground({86, 4, 0})}, {arrow, line}, {});
  EXPECT_NEAR(moved(*all[0].slide, arrow.line.back()).x, 84 - 1 - 0.5 - 2, 1e-9);
}

// A quarter circle of 40 m radius about (0, 40), from the origin, in steps of a degree; the crossing
// lies from 8 to 12 m before its end.
TEST(CrossingLine, TurnsWithItsLane) {
  const auto at = [](double degrees, double radius) {
    return Point{radius * std::sin(degrees * M_PI / 180),
                 40 - radius * std::cos(degrees * M_PI / 180)};
  };
  Line way;
  for (int i = 0; i <= 90; ++i) way.push_back(at(i, 40));
  const double degree = 40 * M_PI / 180, from = 90 - 12 / degree, to = 90 - 8 / degree;
  const MultiPolygon crossing{
      {{at(from, 44), at(to, 44), at(to, 36), at(from, 36), at(from, 44)}}};
  const PaintOnLane at_end{{{41.5, 39.75, 0}, {38.5, 39.75, 0}}};
  const auto all = lay_before_crossings({way, 3, false}, {crossing}, {at_end}, {});
  const Point right = moved(*all[0].slide, at_end.line.front());
  const Point left = moved(*all[0].slide, at_end.line.back()), middle{0, 40, 0};
  EXPECT_NEAR(distance(left, right), 3, 1e-9);
  EXPECT_NEAR(distance(left, middle), 38.5, 0.02);
  EXPECT_NEAR(distance(right, middle), 41.5, 0.02);
  EXPECT_NEAR(std::atan2(left.x, 40 - left.y) * 40, length(way) - 12 - 1.25, 0.05);
}

// Beyond the end of the lane the street bends by 30 degrees.
TEST(CrossingLine, ComesToLieSquareToItsLaneFromBeyondABend) {
  const double angle = 30 * M_PI / 180;
  const Point middle{93, -1, 0}, half{-1.5 * std::sin(angle), 1.5 * std::cos(angle), 0};
  for (const double share : {1.0, 0.5}) {
    const PaintOnLane bent{{middle - half, middle - half + half * (2 * share)}};
    const auto all = lay_before_crossings(along, {ground({86, 4, 0})}, {bent}, {});
    const Point right = moved(*all[0].slide, bent.line.front()),
                left = moved(*all[0].slide, bent.line.back());
    EXPECT_NEAR(right.x, 84 - 1 - 0.25, 1e-9) << share;
    EXPECT_NEAR(left.x, 84 - 1 - 0.25, 1e-9) << share;
    EXPECT_NEAR(left.y - right.y, 3 * share, 1e-9) << share;
    EXPECT_NEAR(right.y, -3.5, 1e-9) << share;
  }
}

}  // namespace crossing_line_test
}  // namespace streetgen
