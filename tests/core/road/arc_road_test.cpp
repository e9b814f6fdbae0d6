#include "streetgen/arc_road.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"
#include "random_line.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"

namespace streetgen {
namespace arc_road_test {

double greatest_jump(const ArcRoad& road) {
  double jump = 0;
  for (const ArcRoad::Stretch& stretch : road.stretches()) {
    if (stretch.start_abscissa == 0) continue;
    const RoadPlace before = road.at(std::nextafter(stretch.start_abscissa, 0));
    jump = std::max(jump, angle_between(before.forward, road.at(stretch.start_abscissa).forward));
  }
  return jump;
}

void expect_same_road(const ArcRoad& a, const ArcRoad& b, double slack = 1e-9) {
  ASSERT_NEAR(a.length(), b.length(), slack * std::max(1.0, a.length()));
  for (int i = 0; i <= 50; ++i) {
    const Point p = a.at(a.length() * i / 50).point, q = b.at(b.length() * i / 50).point;
    ASSERT_LT(space::distance(p, q), slack * 100) << "at " << i << " of 50";
  }
}

template <class Change>
Line changed(Line line, Change change) {
  for (Point& p : line) p = change(p);
  return line;
}

std::string refusal(const Line& line, const ArcRoadFit& fit = {}) {
  try {
    ArcRoad::fit(line, fit);
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::invalid_input);
    return e.what();
  }
  return "";
}

TEST(ArcRoad, OfARightAngle) {
  const ArcRoad road = ArcRoad::fit({{0, 0}, {100, 0}, {100, 60}});
  ASSERT_EQ(road.arcs().size(), 1u);
  const RoadArc& arc = road.arcs()[0];
  EXPECT_EQ(arc.vertex, 1u);
  EXPECT_NEAR(arc.radius, 60, 1e-12);
  EXPECT_NEAR(arc.angle, M_PI / 2, 1e-12);
  EXPECT_NEAR(distance(arc.centre, {40, 60}), 0, 1e-12);
  EXPECT_NEAR(arc.start_abscissa, 40, 1e-12);
  EXPECT_NEAR(arc.end_abscissa, 40 + 30 * M_PI, 1e-12);
  EXPECT_NEAR(road.length(), 40 + 30 * M_PI, 1e-12);
  EXPECT_NEAR(road.at(20).curvature, 0, 0);
  EXPECT_NEAR(road.at(50).curvature, 1.0 / 60, 1e-15);
  EXPECT_NEAR(road.at(road.length()).heading, M_PI / 2, 1e-12);
  EXPECT_NEAR(road.at(-5).point.x, 0, 0);
  EXPECT_NEAR(road.at(1e9).point.y, 60, 1e-12);
}

TEST(ArcRoad, TouchesItsPolylineAndHasOneHeading) {
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    const Line line = random_line(random, {3 + i % 10, 2.9, i % 2 ? 0.4 : 0});
    const ArcRoad road = ArcRoad::fit(line);
    ASSERT_LE(greatest_jump(road), 1e-9) << "line " << i;
    for (const RoadArc& arc : road.arcs()) {
      // The start of equation 12 with its frame corrected, and its tangent.
      const Point& before = line[arc.vertex - 1];
      const Point& corner = line[arc.vertex];
      const Point& after = line[arc.vertex + 1];
      const Point aside = space::cross(arc.orientation, arc.start_direction);
      const auto at = [&](double t) {
        return arc.centre + (arc.start_direction * std::cos(t) + aside * std::sin(t)) * arc.radius;
      };
      const double tangent = arc.radius * std::tan(arc.angle / 2);
      const Point in = space::unit(corner - before), out = space::unit(after - corner);
      const double slack = 1e-11 * std::max(1.0, tangent);
      ASSERT_LT(space::distance(at(0), corner - in * tangent), slack);
      ASSERT_LT(space::distance(at(arc.angle), corner + out * tangent), slack);
      ASSERT_LT(angle_between(aside, in), 1e-9);
      const Point end = aside * std::cos(arc.angle) - arc.start_direction * std::sin(arc.angle);
      ASSERT_LT(angle_between(end, out), 1e-9);
    }
  }
}

TEST(ArcRoad, KeepsItsHeadingThroughThreePointsOfGreatCoordinates) {
  std::mt19937 random(2);
  for (int i = 0; i < 500; ++i) {
    const Line line = changed(random_line(random, {8, 2.6, i % 2 ? 0.1 : 0}), [](const Point& p) {
      return p + Point{652000, 6862000, 0};
    });
    const ArcRoad fitted = ArcRoad::fit(line), road = ArcRoad::along(fitted.curve());
    ASSERT_NEAR(fitted.length(), road.length(), 1e-7);
    const std::vector<ArcRoad::Stretch> stretches = road.stretches();
    for (std::size_t k = 1; k < stretches.size(); ++k) {
      double bound = 1e-9;
      for (const ArcRoad::Stretch& s : {stretches[k - 1], stretches[k]})
        bound += 4e-9 / (s.end_abscissa - s.start_abscissa);
      const double at = stretches[k].start_abscissa;
      const RoadPlace before = road.at(std::nextafter(at, 0)), after = road.at(at);
      ASSERT_LE(angle_between(before.forward, after.forward), bound) << i << " " << k;
    }
  }
}

TEST(ArcRoad, LengthIsThatOfAFinePolyline) {
  std::mt19937 random(3);
  for (int i = 0; i < 50; ++i) {
    const Line line = random_line(random, {10, 2.6, i % 2 ? 0.3 : 0});
    const ArcRoad road = ArcRoad::fit(line);
    // The length of the polyline, and what each arc takes off it.
    double closed = 0, fine = 0;
    for (std::size_t k = 1; k < line.size(); ++k) closed += space::distance(line[k - 1], line[k]);
    for (const RoadArc& arc : road.arcs())
      closed -= arc.radius * (2 * std::tan(arc.angle / 2) - arc.angle);
    ASSERT_NEAR(road.length(), closed, 1e-9 * closed);
    Point from = line.front();
    for (const RoadArc& arc : road.arcs()) {
      const auto at = [&](double t) {
        const Point aside = space::cross(arc.orientation, arc.start_direction);
        return arc.centre + (arc.start_direction * std::cos(t) + aside * std::sin(t)) * arc.radius;
      };
      // Chords fall short by a share of their square: two sums of them tell the limit.
      double sums[2] = {0, 0};
      for (const int chords : {500, 1000})
        for (int k = 0; k < chords; ++k)
          sums[chords / 1000] +=
              space::distance(at(arc.angle * k / chords), at(arc.angle * (k + 1) / chords));
      fine += space::distance(from, at(0)) + (4 * sums[1] - sums[0]) / 3;
      from = at(arc.angle);
    }
    fine += space::distance(from, line.back());
    ASSERT_NEAR(road.length(), fine, 1e-9 * closed);
  }
}

TEST(ArcRoad, LocatesItsOwnPlacesAndThoseBesideIt) {
  std::mt19937 random(4);
  for (int i = 0; i < 300; ++i) {
    const Line line = random_line(random, {9, 1.5, i % 2 ? 0.2 : 0});
    const ArcRoad road = ArcRoad::fit(line);
    double least = 1e9;
    for (const RoadArc& arc : road.arcs()) least = std::min(least, arc.radius);
    for (int k = 0; k <= 20; ++k) {
      const double at = road.length() * k / 20;
      const RoadPlace place = road.at(at);
      const RoadFoot foot = road.locate(place.point);
      ASSERT_NEAR(foot.abscissa, at, 1e-6);
      ASSERT_NEAR(foot.distance, 0, 1e-9);
      const double aside = std::min(0.01, least / 2);
      for (const double offset : {-aside, aside}) {
        const RoadFoot beside = road.locate(place.point - place.right * offset);
        ASSERT_NEAR(beside.abscissa, at, 1e-6) << i << " " << k;
        ASSERT_NEAR(beside.offset, offset, 1e-9);
      }
    }
  }
}

TEST(ArcRoad, LocatesAsTheNearestOfManyPlaces) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> away(-60, 60);
  for (int i = 0; i < 100; ++i) {
    const ArcRoad road = ArcRoad::fit(random_line(random, {8, 2.6, i % 2 ? 0.3 : 0}));
    for (int k = 0; k < 10; ++k) {
      Point p = road.at(road.length() * k / 10).point;
      p.x += away(random), p.y += away(random);
      double nearest = 1e9;
      for (int s = 0; s <= 5000; ++s)
        nearest = std::min(nearest, space::distance(p, road.at(road.length() * s / 5000).point));
      const RoadFoot foot = road.locate(p);
      ASSERT_LE(foot.distance, nearest + 1e-9);
      ASSERT_NEAR(foot.distance, nearest, road.length() / 5000);
      ASSERT_NEAR(space::distance(road.at(foot.abscissa).point, p), foot.distance, 1e-9);
    }
  }
}

TEST(ArcRoad, ReversedMirroredMovedTurnedAndScaledIsTheSame) {
  std::mt19937 random(6);
  for (int i = 0; i < 500; ++i) {
    const Line line = random_line(random, {9, 2.6, i % 2 ? 0.2 : 0});
    ArcRoadFit fit;
    fit.shift = 3;
    const ArcRoad road = ArcRoad::fit(line, fit);
    const ArcRoad back = ArcRoad::fit(reversed(line), fit);
    ASSERT_NEAR(back.length(), road.length(), 1e-9 * road.length());
    const auto same_as = [&](const ArcRoad& other, auto change, double scale) {
      ASSERT_NEAR(other.length(), scale * road.length(), 1e-9 * scale * road.length());
      for (int k = 0; k <= 30; ++k) {
        const Point p = change(road.at(road.length() * k / 30).point);
        ASSERT_LT(space::distance(p, other.at(other.length() * k / 30).point), 1e-7 * scale);
      }
    };
    for (int k = 0; k <= 30; ++k)
      ASSERT_LT(space::distance(road.at(road.length() * k / 30).point,
                                back.at(back.length() * (30 - k) / 30).point),
                1e-7);
    const auto mirror = [](const Point& p) { return Point{-p.x, p.y, p.z}; };
    same_as(ArcRoad::fit(changed(line, mirror), fit), mirror, 1);
    const auto move = [](const Point& p) { return p + Point{1234.5, -987.25, 12}; };
    same_as(ArcRoad::fit(changed(line, move), fit), move, 1);
    const auto turn = [](const Point& p) {
      return Point{0.6 * p.x - 0.8 * p.y, 0.8 * p.x + 0.6 * p.y, p.z};
    };
    same_as(ArcRoad::fit(changed(line, turn), fit), turn, 1);
    const auto scale = [](const Point& p) { return p * 8; };
    fit.shift = 24, fit.cap = 32000;
    same_as(ArcRoad::fit(changed(line, scale), fit), scale, 8);
  }
}

TEST(ArcRoad, AVertexOnASegmentChangesNothing) {
  std::mt19937 random(10);
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < 500; ++i) {
    const Point far = i % 3 == 0 ? Point{652000, 6862000, 0} : Point{};
    const Line line = changed(random_line(random, {8, 2.6, i % 2 ? 0.2 : 0}),
                              [&](const Point& p) { return p + far; });
    Line more;
    for (std::size_t k = 0; k < line.size(); ++k) {
      more.push_back(line[k]);
      if (random() % 3 == 0) more.push_back(line[k]);
      if (k + 1 < line.size() && random() % 2)
        more.push_back(line[k] + (line[k + 1] - line[k]) * share(random));
    }
    const ArcRoad road = ArcRoad::fit(line), other = ArcRoad::fit(more);
    ASSERT_EQ(road.arcs().size(), other.arcs().size()) << i;
    expect_same_road(road, other, i % 3 == 0 ? 1e-7 : 1e-9);
  }
}

TEST(ArcRoad, HasAFrameWithoutTheNormalOfTheBends) {
  // A crest: the plane of the bend stands upright, its normal is horizontal.
  const ArcRoad crest = ArcRoad::fit({{0, 0, 0}, {100, 0, 6}, {200, 0, 0}});
  for (double at = 0; at < crest.length(); at += 5) {
    const RoadPlace place = crest.at(at);
    EXPECT_NEAR(distance(place.right, {0, -1}), 0, 1e-12);
    EXPECT_GT(place.up.z, 0.99);
    EXPECT_NEAR(place.curvature, 0, 1e-15);
  }
  std::mt19937 random(11);
  for (int i = 0; i < 200; ++i) {
    const ArcRoad road = ArcRoad::fit(random_line(random, {8, 2.6, 0.5}));
    for (int k = 0; k <= 40; ++k) {
      const RoadPlace p = road.at(road.length() * k / 40);
      ASSERT_NEAR(p.right.z, 0, 0);
      ASSERT_GT(p.up.z, 0);
      ASSERT_NEAR(space::norm(p.right), 1, 1e-12);
      ASSERT_LT(space::distance(p.up, space::cross(p.right, p.forward)), 1e-12);
      ASSERT_NEAR(space::dot(p.right, p.forward), 0, 1e-12);
    }
  }
  EXPECT_NE(refusal({{0, 0, 0}, {10, 0, 0}, {10, 0, 5}, {20, 0, 5}}).find("after vertex 2"),
            std::string::npos);
}

TEST(ArcRoad, ShiftsByNoMoreThanAsked) {
  // Radii by angle for half a metre.
  for (const auto& [degrees, radius] : {std::pair{10, 131.0}, {20, 32.4}, {30, 14.2}, {90, 1.2}}) {
    const double turn = degrees * M_PI / 180;
    ArcRoadFit fit;
    fit.shift = 0.5;
    const Line line{{0, 0}, {500, 0}, {500 + 500 * std::cos(turn), 500 * std::sin(turn)}};
    const ArcRoad road = ArcRoad::fit(line, fit);
    EXPECT_NEAR(road.arcs()[0].radius, radius, 0.01 * radius);
    EXPECT_NEAR(road.locate(line[1]).distance, 0.5, 1e-9);
  }
}

TEST(ArcRoad, SpeedLimitIsThatOfEquationSeven) {
  EXPECT_NEAR(arc_speed_limit(5, 0.7, 0, 1), 21, 0.5);
  EXPECT_NEAR(arc_speed_limit(30, 0.7, 0, 1), 52, 0.5);
  EXPECT_NEAR(arc_speed_limit(100, 0.7, 0, 1), 94, 0.5);
  EXPECT_NEAR(arc_speed_limit(100, 0.7, 0.06, 0.8),
              0.8 * 3.6 * std::sqrt(9.81 * 100 * 0.76 / (1 - 0.042)), 1e-9);
  EXPECT_EQ(arc_speed_limit(100, 0.1, -0.2, 1), 0);
}

TEST(ArcRoad, GivesAResultForOddLines) {
  EXPECT_NEAR(ArcRoad::fit({{0, 0}, {10, 0}}).length(), 10, 0);
  EXPECT_TRUE(ArcRoad::fit({{0, 0}, {5, 0}, {10, 0}, {20, 0}}).arcs().empty());
  const ArcRoad back = ArcRoad::fit({{0, 0}, {50, 0}, {20, 0}, {20, 40}});
  ASSERT_EQ(back.arcs().size(), 2u);
  EXPECT_EQ(back.arcs()[0].radius, 0);
  EXPECT_NEAR(back.arcs()[0].angle, M_PI, 1e-12);
  EXPECT_NEAR(back.arcs()[1].radius, 30, 1e-9);
  const ArcRoad closed = ArcRoad::fit({{0, 0}, {40, 0}, {40, 40}, {0, 40}, {0, 0}});
  EXPECT_EQ(closed.arcs().size(), 3u);
  EXPECT_NEAR(distance(closed.at(0).point, closed.at(closed.length()).point), 0, 1e-12);
  const ArcRoad uneven = ArcRoad::fit({{0, 0}, {1, 0}, {1, 1000}});
  EXPECT_NEAR(uneven.arcs()[0].radius, 1, 1e-12);
  Line helix;
  for (int i = 0; i < 2000; ++i)
    helix.push_back({30 * std::cos(i * 0.05), 30 * std::sin(i * 0.05), 0.01 * i});
  const ArcRoad ramp = ArcRoad::fit(helix);
  const double at = 0.7 * ramp.length();
  EXPECT_NEAR(ramp.locate(ramp.at(at).point).abscissa, at, 1e-6);
  EXPECT_LE(greatest_jump(ramp), 1e-9);
}

TEST(ArcRoad, RefusesBadInputByVertexAndValue) {
  const Line line{{0, 0}, {50, 0}, {50, 50}};
  ArcRoadFit fit;
  EXPECT_EQ(refusal({{0, 0}, {NAN, 1}}), "vertex 2 has x nan, expected a finite number");
  EXPECT_EQ(refusal({{0, 0}, {1, INFINITY}}), "vertex 2 has y inf, expected a finite number");
  EXPECT_NE(refusal({{5, 5}, {5, 5}}), "");
  EXPECT_NE(refusal({}), "");
  fit.cap = -1;
  EXPECT_EQ(refusal(line, fit), "cap is -1, expected a finite number of 0 or more");
  fit.cap = INFINITY;
  EXPECT_NE(refusal(line, fit), "");
  fit = {};
  fit.shift = NAN;
  EXPECT_EQ(refusal(line, fit), "shift is nan, expected a finite number of 0 or more");
  fit = {};
  fit.radii = {1, 2};
  EXPECT_NE(refusal(line, fit).find("2 elements"), std::string::npos);
  fit.radii = {{}, -3, {}};
  EXPECT_EQ(refusal(line, fit),
            "the radius of vertex 2 is -3, expected a finite number of 0 or more");
  fit.radii = {{}, 60, {}};
  EXPECT_EQ(refusal(line, fit),
            "the radius of vertex 2 is 60, but the bend has room for 50 at most");
  fit.radii = {{}, 50, {}};
  EXPECT_EQ(ArcRoad::fit(line, fit).arcs()[0].radius, 50);
}

TEST(ArcRoad, StopsWhereTheCallerAsks) {
  Line line;
  for (int i = 0; i < 100000; ++i) line.push_back({1.0 * i, i % 2 * 0.5});
  set_cancel_check([]() noexcept { return true; });
  EXPECT_THROW(ArcRoad::fit(line), Error);
  set_cancel_check(nullptr);
}

TEST(ArcRoad, OfAMillionVerticesIsARoad) {
  Line line;
  for (int i = 0; i < 1000000; ++i) line.push_back({1.0 * i, i % 2 * 0.5});
  const ArcRoad road = ArcRoad::fit(line);
  EXPECT_EQ(road.arcs().size(), 999998u);
  const double at = 0.37 * road.length();
  EXPECT_NEAR(road.locate(road.at(at).point).abscissa, at, 1e-6);
}

}  // namespace arc_road_test
}  // namespace streetgen
