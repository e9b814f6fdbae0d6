#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "geometry/polyline.hpp"
#include "random_line.hpp"
#include "rounds.hpp"
#include "streetgen/arc_road.hpp"
#include "streetgen/error.hpp"

namespace streetgen {
namespace road_offset_test {

constexpr double step = 0.05;

// The least and the greatest distance from the road at places along another one.
std::pair<double, double> distances(const ArcRoad& road, const ArcRoad& other) {
  double least = 1e9, greatest = 0;
  for (double at = 0; at < other.length(); at += step) {
    const double away = road.locate(other.at(at).point).distance;
    least = std::min(least, away), greatest = std::max(greatest, away);
  }
  return {least, greatest};
}

double turned_area(const std::vector<Triangle>& triangles, bool upright) {
  double sum = 0;
  for (const Triangle& t : triangles) {
    const double area = cross(t[1] - t[0], t[2] - t[0]) / 2;
    if ((area > 0) == upright) sum += std::abs(area);
  }
  return sum;
}

// How often each edge is used, by both directions.
bool is_strip(const std::vector<Triangle>& triangles) {
  std::map<std::pair<std::tuple<double, double, double>, std::tuple<double, double, double>>, int>
      uses;
  const auto key = [](const Point& p) { return std::tuple{p.x, p.y, p.z}; };
  for (const Triangle& t : triangles)
    for (int i = 0; i < 3; ++i)
      if (++uses[{key(t[i]), key(t[(i + 1) % 3])}] > 1) return false;
  return true;
}

TEST(RoadOffset, AddsToRightBendsAndTakesFromLeftOnes) {
  // Positive to the left: against the paper's signs, which hide the side.
  const ArcRoad road = ArcRoad::fit({{0, 0}, {100, 0}, {100, 100}, {200, 100}});
  const auto left = road.offset(3)->stretches(), right = road.offset(-3)->stretches();
  const auto own = road.stretches();
  std::size_t arcs = 0;
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (own[i].radius == 0) continue;
    EXPECT_NEAR(left[i].radius, own[i].radius - 3, 1e-9);
    EXPECT_NEAR(right[i].radius, own[i].radius + 3, 1e-9);
    ++arcs;
  }
  EXPECT_EQ(arcs, 2u);
  // Ends lie beside the ends, whatever bends there.
  EXPECT_NEAR(distance(road.offset(3)->at(0).point, {0, 3}), 0, 1e-12);
  EXPECT_NEAR(distance(road.offset(-3)->at(1e9).point, {200, 97}), 0, 1e-12);
}

TEST(RoadOffset, ShiftsByTheWholeOffsetAtGentleBends) {
  // Equations 9 and 10 would shift by the offset times the sine of the bend.
  for (const double rise : {1.0, -1.0}) {
    const ArcRoad road = ArcRoad::fit({{0, 0}, {100, 0}, {200, rise}});
    EXPECT_NEAR(distance(road.offset(5)->at(0).point, {0, 5}), 0, 1e-12);
    const Point end = road.offset(5)->at(1e9).point;
    EXPECT_NEAR(distance(end, {200, rise}), 5, 1e-9);
    EXPECT_GT(end.y, rise);
  }
}

TEST(RoadOffset, IsExactBesideBendsThatAreWider) {
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    const ArcRoad road = ArcRoad::fit(random_line(random, {6, 1.2}));
    double least = 1e9;
    for (const RoadArc& arc : road.arcs()) least = std::min(least, arc.radius);
    for (const double offset : {-0.9 * least, 0.9 * least}) {
      const ArcRoad other = *road.offset(offset);
      ASSERT_EQ(other.stretches().size(), road.stretches().size());
      const auto [nearest, farthest] = distances(road, other);
      ASSERT_LE(farthest, std::abs(offset) + 1e-9);
      // There and back.
      const ArcRoad again = *other.offset(-offset);
      ASSERT_NEAR(again.length(), road.length(), 1e-9 * road.length());
      const std::vector<ArcRoad::Stretch> stretches = other.stretches();
      for (const ArcRoad::Stretch& s : stretches) {
        const double at = s.start_abscissa;
        if (at == 0) continue;
        ASSERT_LT(angle_between(other.at(std::nextafter(at, 0)).forward, other.at(at).forward),
                  1e-9);
      }
    }
  }
}

TEST(RoadOffset, CutsOutWhatInnerBendsTurnOver) {
  // A bend of radius 10: its inner side at 15 m is where the two straight borders meet.
  ArcRoadFit fit;
  fit.cap = 10;
  const ArcRoad road = ArcRoad::fit({{0, 0}, {100, 0}, {100, 100}}, fit);
  const ArcRoad inner = *road.offset(15);
  ASSERT_EQ(inner.stretches().size(), 2u);
  EXPECT_NEAR(inner.length(), 170, 1e-9);
  EXPECT_NEAR(distance(inner.at(85).point, {85, 15}), 0, 1e-9);
  EXPECT_NEAR(road.offset(-15)->length(), 180 + 25 * M_PI / 2, 1e-9);
  // As tight as the offset: the arc is a point.
  EXPECT_NEAR(road.offset(10)->length(), 180, 1e-9);
  std::mt19937 random(2);
  for (int i = 0; i < rounds(400); ++i) {
    ArcRoadFit tight;
    tight.cap = 1 + i % 7;
    const ArcRoad bends = ArcRoad::fit(random_line(random, {7, 0.6, 0, true}), tight);
    for (const double offset : {-8.0, 8.0}) {
      const auto beside = bends.offset(offset);
      if (!beside) continue;
      const auto [nearest, farthest] = distances(bends, *beside);
      ASSERT_GE(nearest, 8 - 1e-6) << i << " " << offset;
      ASSERT_LE(farthest, 8 + 1e-6) << i << " " << offset;
    }
  }
}

TEST(RoadOffset, GoesRoundSharpBends) {
  ArcRoadFit fit;
  fit.cap = 0;
  const ArcRoad road = ArcRoad::fit({{0, 0}, {50, 0}, {50, 50}}, fit);
  EXPECT_NEAR(road.offset(-4)->length(), 100 + 2 * M_PI, 1e-9);
  EXPECT_NEAR(road.offset(4)->length(), 92, 1e-9);
  const ArcRoad back = ArcRoad::fit({{0, 0}, {50, 0}, {10, 0}});
  EXPECT_NEAR(back.offset(-4)->length(), 90 + 4 * M_PI, 1e-9);
  EXPECT_NEAR(back.offset(4)->length(), 90 + 4 * M_PI, 1e-9);
}

TEST(RoadOffset, InSpaceKeepsToItsBound) {
  std::mt19937 random(3);
  for (int i = 0; i < 1000; ++i) {
    const double slope = 0.02 * (1 + i % 9);
    const Line line = random_line(random, {7, 1.5, slope});
    const ArcRoad road = ArcRoad::fit(line);
    double least = 1e9, sharpest = 0;
    for (const RoadArc& arc : road.arcs()) {
      least = std::min(least, arc.radius);
      const Point in = planar(line[arc.vertex] - line[arc.vertex - 1]);
      const Point out = planar(line[arc.vertex + 1] - line[arc.vertex]);
      sharpest = std::max(sharpest, angle_between(in, out));
    }
    const double offset = (i % 2 ? 0.5 : -0.5) * std::min(least, 10.0);
    const ArcRoad other = *road.offset(offset);
    for (const ArcRoad::Stretch& s : other.stretches())
      if (s.start_abscissa > 0) {
        const RoadPlace before = other.at(std::nextafter(s.start_abscissa, 0));
        ASSERT_LT(angle_between(before.forward, other.at(s.start_abscissa).forward), 1e-9);
      }
    const double bound = std::abs(offset) * slope * (1 + std::tan(sharpest / 2));
    for (int k = 0; k <= 100; ++k) {
      const RoadPlace place = road.at(road.length() * k / 100);
      const Point beside = place.point - place.right * offset;
      const double away = other.locate(beside).distance;
      ASSERT_LE(away, bound + 1e-9) << i << " at " << k;
    }
  }
}

TEST(RoadLine, LeavesTheRoadByNoMoreThanTheTolerance) {
  std::mt19937 random(4);
  for (int i = 0; i < 200; ++i) {
    const ArcRoad road = ArcRoad::fit(random_line(random, {7, 2.6, i % 2 ? 0.3 : 0}));
    for (const double tolerance : {0.001, 0.05, 1.0}) {
      const Line line = road.line(tolerance);
      double farthest = 0;
      for (std::size_t k = 1; k < line.size(); ++k)
        for (const double share : {0.25, 0.5, 0.75})
          farthest = std::max(farthest,
                              road.locate(line[k - 1] + (line[k] - line[k - 1]) * share).distance);
      ASSERT_LE(farthest, tolerance * (1 + 1e-9));
    }
  }
}

TEST(RoadMesh, HasTheAreaOfAWidthAlongTheRoad) {
  std::mt19937 random(5);
  for (int i = 0; i < 100; ++i) {
    const ArcRoad road = ArcRoad::fit(random_line(random, {7, 1.2}));
    double least = 1e9;
    for (const RoadArc& arc : road.arcs()) least = std::min(least, arc.radius);
    const double width = std::min(4.0, least / 2);
    const std::vector<Triangle> mesh = road.mesh(width, -width, 0.001);
    ASSERT_EQ(mesh.size() % 2, 0u);
    ASSERT_NEAR(turned_area(mesh, true), 2 * width * road.length(), 0.004 * road.length());
    ASSERT_EQ(turned_area(mesh, false), 0);
    ASSERT_TRUE(is_strip(mesh));
  }
}

TEST(RoadMesh, DoesNotFoldInTightBends) {
  std::mt19937 random(6);
  for (int i = 0; i < 200; ++i) {
    ArcRoadFit tight;
    tight.cap = i % 5;
    const ArcRoad road = ArcRoad::fit(random_line(random, {6, 0.5, i % 2 ? 0.05 : 0, true}), tight);
    const std::vector<Triangle> mesh = road.mesh(8, -2, 0.01);
    ASSERT_TRUE(is_strip(mesh)) << i;
    ASSERT_LE(turned_area(mesh, false), 1e-6) << i;
  }
}

TEST(RoadMesh, BordersOfARoadInSpaceKeepToTheTolerance) {
  std::mt19937 random(7);
  for (int i = 0; i < 50; ++i) {
    const ArcRoad road = ArcRoad::fit(random_line(random, {6, 1.2, 0.3}));
    double least = 1e9;
    for (const RoadArc& arc : road.arcs()) least = std::min(least, arc.radius);
    const double width = std::min(4.0, least / 2);
    for (const Triangle& t : road.mesh(width, -width, 0.01))
      for (const Point& p : t) {
        const RoadFoot foot = road.locate(p);
        ASSERT_LE(std::abs(foot.offset), width + 1e-6);
      }
  }
}

TEST(RoadMesh, RefusesOffsetsInTheWrongOrder) {
  const ArcRoad road = ArcRoad::fit({{0, 0}, {50, 0}});
  EXPECT_THROW(road.mesh(-2, 2, 0.1), Error);
  EXPECT_EQ(road.mesh(2, -2, 0.1).size(), 2u);
}

}  // namespace road_offset_test
}  // namespace streetgen
