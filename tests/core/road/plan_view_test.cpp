#include "streetgen/plan_view.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "geometry/polyline.hpp"
#include "random_line.hpp"
#include "smooth_chain.hpp"
#include "streetgen/error.hpp"
#include "streetgen/road_lanes.hpp"

namespace streetgen {
namespace plan_view_test {

double side_heading(const Point& from, const Point& to) {
  return std::atan2(to.y - from.y, to.x - from.x);
}

TEST(PlanView, LiesWithinTheToleranceOfRandomLines) {
  std::mt19937 random(20);
  for (int i = 0; i < 200; ++i) {
    const double tolerance = i % 3 == 0 ? 0.05 : i % 3 == 1 ? 0.01 : 0.5;
    const Line line = random_line(random, {2 + i % 9, 3.0});
    const std::vector<PlanPiece> chain = plan_view(line, tolerance);
    expect_smooth(chain);
    expect_within(chain, line, tolerance);
    EXPECT_LT(distance(chain.front().start.point, planar(line.front())), 1e-9);
    EXPECT_LT(distance(place_at(chain, length(chain)).point, planar(line.back())), 1e-6);
  }
}

TEST(PlanView, HasTheHeadingsThatAreGiven) {
  std::mt19937 random(21);
  std::uniform_real_distribution<double> turned(-2, 2);
  for (int i = 0; i < 200; ++i) {
    const Line line = random_line(random, {2 + i % 5, 2.5});
    const ChainEnds ends{side_heading(line[0], line[1]) + turned(random),
                         side_heading(line[line.size() - 2], line.back()) + turned(random)};
    const std::vector<PlanPiece> chain = plan_view(line, 0.05, ends);
    expect_smooth(chain);
    EXPECT_LT(turn_between(chain.front().start.heading, *ends.heading_from), 1e-9);
    EXPECT_LT(turn_between(place_at(chain, length(chain)).heading, *ends.heading_to), 1e-6);
  }
}

// What is written has seven digits.
TEST(PlanView, HasNoPieceOfNothing) {
  for (const double beside : {1.0, 1e-3, 1e-6, 1e-8, 1e-9})
    for (const PlanPiece& piece : plan_view({{0, 0}, {10, 0}, {10 + beside, 10}, {20, 10}}, 0.5))
      EXPECT_GT(piece.length, 5e-8);
}

TEST(PlanView, OfAStraightLineIsALine) {
  const auto chain = plan_view({{3, 4}, {6, 8}, {9, 12}}, 0.05);
  ASSERT_EQ(chain.size(), 1u);
  EXPECT_EQ(chain[0].curvature, 0);
  EXPECT_NEAR(chain[0].length, 10, 1e-12);
  EXPECT_NEAR(chain[0].start.heading, std::atan2(4, 3), 1e-12);
}

TEST(PlanView, PutsAnArcIntoAKink) {
  const auto chain = plan_view({{0, 0}, {50, 0}, {50, 50}}, 0.1);
  ASSERT_EQ(chain.size(), 3u);
  EXPECT_GT(chain[1].curvature, 0);
  // Half the tolerance lies between the corner and the arc: R (sqrt 2 - 1).
  EXPECT_NEAR(1 / chain[1].curvature, 0.05 / (std::sqrt(2) - 1), 1e-9);
  EXPECT_NEAR(chain[1].length * chain[1].curvature, M_PI / 2, 1e-9);
}

TEST(PlanView, GoesAboutWhereALineTurnsBack) {
  for (const Line& line : {Line{{0, 0}, {20, 0}, {5, 0}}, Line{{0, 0}, {5, 0}, {-15, 0.01}}}) {
    const auto chain = plan_view(line, 0.05);
    expect_smooth(chain);
    expect_within(chain, line, 0.05);
  }
}

TEST(PlanView, OfNothingIsNothing) {
  EXPECT_TRUE(plan_view({{1, 1}, {1, 1}}, 0.05).empty());
  EXPECT_THROW(place_at({}, 0), Error);
}

// A road of two bends with clothoids.
std::vector<AlignmentElement> two_bends() {
  return horizontal_alignment({{0, 0}, {400, 0}, {700, 300}, {1100, 300}},
                              {{}, {130, 70, 70}, {200, 90, 60}, {}});
}

TEST(CourseBeside, HasTheElementsBetweenTheEndsOfALine) {
  const std::vector<AlignmentElement> elements = two_bends();
  std::mt19937 random(24);
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < 100; ++i) {
    const double from = share(random) * alignment_length(elements);
    const double to = share(random) * alignment_length(elements);
    if (std::abs(from - to) < 1) continue;
    Line line;
    for (int k = 0; k <= 50; ++k)
      line.push_back(alignment_place(elements, from + (to - from) * k / 50).point);
    const std::vector<PlanPiece> course = course_beside(elements, line, 0.01);
    ASSERT_FALSE(course.empty());
    expect_smooth(course);
    ASSERT_NEAR(length(course), std::abs(from - to), 1e-3);
    for (int k = 0; k <= 50; ++k) {
      const AlignmentPlace place = alignment_place(elements, from + (to - from) * k / 50);
      const ChainPlace found = place_at(course, length(course) * k / 50);
      ASSERT_LT(distance(planar(place.point), found.point), 1e-3);
      ASSERT_LT(turn_between(place.heading + (from < to ? 0 : M_PI), found.heading), 1e-4);
    }
  }
}

TEST(PlanView, HasAsWideArcsAsAskedWhereSidesHaveRoom) {
  for (const double turn : {0.1, 0.5, 1.0}) {
    const Line line{{0, 0}, {20, 0}, Point{20, 0} + Point{std::cos(turn), std::sin(turn)} * 20};
    const auto chain = plan_view(line, 0.05, {}, 4);
    expect_smooth(chain);
    ASSERT_EQ(chain.size(), 3u);
    EXPECT_LE(chain[1].curvature, 1 / 4.0 + 1e-9);
    expect_within(chain, line, std::max(0.05, 4 / std::cos(turn / 2) - 4));
  }
  // Its arc would leave the corner by more than a metre.
  const Line sharp{{0, 0}, {50, 0}, {50, 50}};
  expect_within(plan_view(sharp, 0.05, {}, 20), sharp, 1);
}

TEST(CourseBeside, IsNoneOfALineThatGoesElsewhere) {
  const std::vector<AlignmentElement> elements = two_bends();
  EXPECT_FALSE(course_beside(elements, {{10, 9}, {200, 9}}, 9.1).empty());
  EXPECT_TRUE(course_beside(elements, {{10, 9}, {200, 9}}, 8.9).empty());
  EXPECT_TRUE(course_beside(elements, {{-10, 0}, {200, 0}}, 9).empty());
  EXPECT_TRUE(course_beside(elements, {{10, 0}, {200, 0}, {100, 0}, {300, 0}}, 9).empty());
  EXPECT_TRUE(course_beside({}, {{10, 0}, {200, 0}}, 9).empty());
  // A vertex without a curve is a kink.
  const auto sharp = horizontal_alignment({{0, 0}, {50, 0}, {50, 50}}, {{}, {}, {}});
  EXPECT_TRUE(course_beside(sharp, {{0, 0}, {50, 0}, {50, 50}}, 1).empty());
  EXPECT_EQ(course_beside(sharp, {{0, 0}, {40, 0}}, 1).size(), 1u);
}

TEST(ChainStation, IsWhereAPointLiesBesideAClothoid) {
  const std::vector<AlignmentElement> elements = two_bends();
  const std::vector<PlanPiece> chain =
      course_beside(elements, {elements.front().start, alignment_place(elements, 1e9).point}, 1e3);
  ASSERT_FALSE(chain.empty());
  for (double s = 1; s < length(chain) - 1; s += 3.7) {
    const ChainPlace place = place_at(chain, s);
    const double aside = s < 500 ? 7 : -7;
    const ChainStation found = station_of(
        chain, place.point + Point{-std::sin(place.heading), std::cos(place.heading), 0} * aside);
    ASSERT_NEAR(found.s, s, 1e-6);
    ASSERT_NEAR(found.aside, aside, 1e-6);
    ASSERT_LT(turn_between(found.heading, place.heading), 1e-9);
  }
}

// Out to the left and back again.
TEST(ChainStation, IsWhereThePointWasPut) {
  std::mt19937 random(23);
  std::uniform_real_distribution<double> share(0, 1), off(-1, 1);
  for (int i = 0; i < 500; ++i) {
    const std::vector<PlanPiece> chain = plan_view(random_line(random, {2 + i % 5, 0.8}), 0.2);
    const double s = share(random) * length(chain);
    const ChainPlace place = place_at(chain, s);
    double aside = 3 * off(random);
    // Nearer than the centre of any arc, so that no other place of its piece is as near.
    for (const PlanPiece& piece : chain)
      aside = std::clamp(aside, -0.4 / std::max(std::abs(piece.curvature), 1e-9),
                         0.4 / std::max(std::abs(piece.curvature), 1e-9));
    const Point beside =
        place.point + Point{-std::sin(place.heading), std::cos(place.heading), 0} * aside;
    const ChainStation found = station_of(chain, beside);
    const ChainPlace nearest = place_at(chain, found.s);
    // Another part of the chain may come nearer; the way back leads to the point in any case.
    const Point back = nearest.point +
                       Point{-std::sin(found.heading), std::cos(found.heading), 0} * found.aside +
                       Point{std::cos(found.heading), std::sin(found.heading), 0} * found.beyond;
    ASSERT_LT(distance(back, beside), 1e-6);
    ASSERT_LE(std::hypot(found.aside, found.beyond), std::abs(aside) + 1e-6);
  }
}

TEST(ChainStation, SaysHowFarBeyondTheEndsAPointLies) {
  const auto chain = plan_view({{0, 0}, {50, 0}, {50, 50}}, 0.1);
  const ChainStation before = station_of(chain, {-3, 2}), behind = station_of(chain, {49, 54, 7});
  EXPECT_EQ(before.s, 0);
  EXPECT_NEAR(before.aside, 2, 1e-9);
  EXPECT_NEAR(before.beyond, -3, 1e-9);
  EXPECT_NEAR(behind.s, length(chain), 1e-9);
  EXPECT_NEAR(behind.aside, 1, 1e-6);
  EXPECT_NEAR(behind.beyond, 4, 1e-6);
  EXPECT_EQ(station_of(chain, {20, -3}).beyond, 0);
  EXPECT_THROW(station_of({}, {0, 0}), Error);
}

MultiPolygon strip(double left, double right, double left_end, double right_end) {
  return {{{{0, right}, {40, right_end}, {40, left_end}, {0, left}, {0, right}}}};
}

TEST(RoadLanes, HaveTheBordersOfTheirSurfaces) {
  const std::vector<LaneGround> lanes{{strip(3, 0, 5, 1), {{0, 1.5}, {40, 3}}, 3},
                                      {strip(0, -3, 1, -3), {{0, -1.5}, {40, -1}}, 3}};
  const RoadLanes road = road_lanes({{0, 0}, {40, 0}}, lanes, 0.05);
  EXPECT_EQ(road.stations, (std::vector<double>{0, 40}));
  const double wanted[3][2] = {{3, 5}, {0, 1}, {-3, -3}};
  for (int p = 0; p < 3; ++p)
    for (int end = 0; end < 2; ++end) EXPECT_NEAR(road.borders[p][end], wanted[p][end], 1e-3);
  EXPECT_NEAR(road.ends[0].width, 4, 1e-3);
  EXPECT_NEAR(road.ends[0].middle.point.y, 3, 1e-3);
  EXPECT_NEAR(road.ends[0].middle.heading, std::atan2(1.5, 40), 1e-3);
}

TEST(RoadLanes, WithoutASurfaceLieAboutTheirLine) {
  const RoadLanes road = road_lanes({{0, 0}, {0, 9}}, {{{}, {{-2, 0}, {-2, 9}}, 3}}, 0.05);
  ASSERT_EQ(road.borders.size(), 2u);
  EXPECT_NEAR(road.borders[0][0], 3.5, 1e-9);
  EXPECT_NEAR(road.borders[1][0], 0.5, 1e-9);
}

TEST(RoadLanes, MayHaveHalfAGround) {
  const MultiPolygon ground = strip(3, -3, 5, -3);
  const Line line{{0, 0}, {40, 1}};
  const RoadLanes road = road_lanes(
      {{0, 0}, {40, 0}},
      {{ground, line, 6, LanePart::left_half}, {ground, line, 6, LanePart::right_half}}, 0.05);
  ASSERT_EQ(road.borders.size(), 3u);
  const double wanted[3][2] = {{3, 5}, {0, 1}, {-3, -3}};
  for (int p = 0; p < 3; ++p)
    for (int end = 0; end < 2; ++end) EXPECT_NEAR(road.borders[p][end], wanted[p][end], 1e-3);
}

// Parts of a road lie on it, and one begins where the other ends.
TEST(RoadPart, LiesOnItsRoad) {
  const Line axis{{0, 0}, {20, 0}, {30, 5}, {40, 30}};
  const RoadLanes road = road_lanes(axis, {{{}, axis, 3}, {{}, {{0, -3}, {40, 27}}, 3}}, 0.05);
  const double cut = 23.7;
  const RoadLanes first = road_part(road, 0, cut), last = road_part(road, cut, length(road.chain));
  EXPECT_NEAR(length(first.chain) + length(last.chain), length(road.chain), 1e-9);
  for (double s = 0; s < length(road.chain); s += 0.37) {
    const ChainPlace there = place_at(road.chain, s);
    const ChainPlace here = s < cut ? place_at(first.chain, s) : place_at(last.chain, s - cut);
    EXPECT_NEAR(distance(here.point, there.point), 0, 1e-9) << s;
    EXPECT_NEAR(here.heading, there.heading, 1e-9) << s;
  }
  for (int lane = 0; lane < 2; ++lane) {
    EXPECT_NEAR(distance(first.ends[lane].middle.point, last.starts[lane].middle.point), 0, 1e-9);
    EXPECT_NEAR(first.ends[lane].middle.heading, last.starts[lane].middle.heading, 1e-9);
    EXPECT_NEAR(first.ends[lane].width, last.starts[lane].width, 1e-9);
    EXPECT_NEAR(distance(last.ends[lane].middle.point, road.ends[lane].middle.point), 0, 1e-9);
  }
}

// Beside the chain there is no part.
TEST(RoadPart, NeedsAChain) {
  const Line axis{{0, 0}, {10, 0}};
  const RoadLanes road = road_lanes(axis, {{{}, axis, 3}}, 0.05);
  for (const auto& part :
       {road_part(road, 10, 20), road_part({{}, {0, 10}, {{1, 1}, {-1, -1}}}, 0, 5)})
    EXPECT_TRUE(part.stations.empty() && part.borders.empty() && part.starts.empty());
}

// A path that is led aside keeps to its line less and less: it is never farther than at its ends.
TEST(PathBeside, LeadsToPlacesBesideItsEnds) {
  Line path;
  for (int i = 0; i <= 20; ++i)
    path.push_back({10 * std::sin(i * M_PI / 40), 10 - 10 * std::cos(i * M_PI / 40)});
  const ChainPlace from{{0, -0.75}, 0}, to{{10, 10}, M_PI / 2};
  const Line beside = path_beside(path, from, to);
  ASSERT_EQ(beside.size(), path.size());
  EXPECT_NEAR(distance(beside.front(), from.point), 0, 1e-2);
  EXPECT_NEAR(distance(beside.back(), to.point), 0, 1e-9);
  for (std::size_t i = 1; i < path.size(); ++i)
    EXPECT_LT(distance(beside[i], path[i]), distance(beside[i - 1], path[i - 1]) + 1e-9) << i;
  EXPECT_EQ(path_beside(path, {{0, 0}, 0}, to).size(), path.size());
  for (const PlanPiece& piece : path_view(path, from, to, 0.05, 3.5))
    EXPECT_LT(std::abs(piece.curvature), 1.0 / 5);
}

// The normal of a place before a right angle runs along the lane behind it.
TEST(RoadLanes, DoNotLookAlongTheLaneBehindABend) {
  const Line axis{{0, 0}, {30, 0}, {30, 30}};
  const MultiPolygon corner{{{{0, -2}, {32, -2}, {32, 30}, {28, 30}, {28, 2}, {0, 2}, {0, -2}}}};
  const RoadLanes road = road_lanes(axis, {{corner, axis, 4}}, 0.05);
  for (std::size_t i = 0; i < road.stations.size(); ++i)
    EXPECT_LT(road.borders[0][i] - road.borders[1][i], 4 * std::sqrt(2) + 0.01) << i;
}

}  // namespace plan_view_test
}  // namespace streetgen
