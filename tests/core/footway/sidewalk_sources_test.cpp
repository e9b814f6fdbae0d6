#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "streetgen/footway.hpp"

namespace streetgen {
namespace {

const LevelLine street{{{0, 0}, {100, 0}}, 0};
const std::vector<StreetSide> both_sides{{0, true, 4, 4}, {0, false, 4, 4}};

std::vector<SidewalkSource> beside(const std::vector<LevelLine>& footways,
                                   const std::vector<StreetSide>& sides = both_sides) {
  return sidewalk_sources({street}, sides, footways, FootwayMatch{});
}

TEST(SidewalkSources, AFootwayAlongAStreetIsTheSidewalkOfItsSide) {
  const auto sources = beside({{{{10, 6}, {90, 6}}, 0}, {{{90, -7}, {10, -7}}, 0}});
  ASSERT_EQ(sources.size(), 2u);
  EXPECT_EQ(sources[0].side, 0);
  EXPECT_EQ(sources[0].footway, 0);
  EXPECT_NEAR(sources[0].distance, 2, 1e-9);
  // Looks stand every 2 m, in the middle of their piece.
  EXPECT_NEAR(sources[0].start, 10, 1);
  EXPECT_NEAR(sources[0].end, 90, 1);
  EXPECT_EQ(sources[1].side, 1);
  EXPECT_NEAR(sources[1].distance, 3, 1e-9);
}

TEST(SidewalkSources, WhatIsFarCrossesOrLiesOnAnotherLevelIsNone) {
  EXPECT_TRUE(beside({{{{10, 17}, {90, 17}}, 0}}).empty());
  EXPECT_TRUE(beside({{{{50, -10}, {50, 10}}, 0}}).empty());
  EXPECT_TRUE(beside({{{{10, 6}, {90, 6}}, 1}}).empty());
  // Beyond the end of the street.
  EXPECT_TRUE(beside({{{{101, 6}, {150, 6}}, 0}}).empty());
  // In the middle of the roadway.
  EXPECT_TRUE(beside({{{{10, 0.5}, {90, 0.5}}, 0}}).empty());
  EXPECT_TRUE(beside({{{{10, 6}, {10, 6}}, 0}}).empty());
  EXPECT_TRUE(beside({{{{10, 6}, {90, 6}}, 0}}, {}).empty());
}

TEST(SidewalkSources, AFootwayJustWithinTheKerbHasADistanceBelowZero) {
  const auto sources = beside({{{{10, 3}, {90, 3}}, 0}});
  ASSERT_EQ(sources.size(), 1u);
  EXPECT_NEAR(sources[0].distance, -1, 1e-9);
}

TEST(SidewalkSources, AFootwayAlongTheMiddleOfANarrowStreetIsOfNeitherSide) {
  EXPECT_TRUE(
      beside({{{{0, 0}, {100, 0}}, 0}}, {{0, true, 1.5, 1.5}, {0, false, 1.5, 1.5}}).empty());
}

// The roadway lies beside the axis, all of it on the right.
TEST(SidewalkSources, AKerbBeyondTheAxisHasFootwaysBesideIt) {
  const auto sources = beside({{{{10, -2}, {90, -2}}, 0}}, {{0, true, -3, -3}});
  ASSERT_EQ(sources.size(), 1u);
  EXPECT_NEAR(sources[0].distance, 1, 1e-9);
}

// What lies far from all streets is not looked at: else this would not end.
TEST(SidewalkSources, AnEndlessFootwayIsLookedAtWhereStreetsAre) {
  const auto sources = beside({{{{-1e12, 6}, {1e12, 6}}, 0}});
  ASSERT_EQ(sources.size(), 1u);
  EXPECT_NEAR(sources[0].start, 0, 2.1);
  EXPECT_NEAR(sources[0].end, 100, 2.1);
}

TEST(SidewalkSources, PiecesFarApartAreStretchesOfTheirOwn) {
  // It leaves the street by more than its distance, and comes back.
  const auto sources = beside({{{{10, 6}, {30, 6}, {31, 40}, {69, 40}, {70, 6}, {90, 6}}, 0}});
  ASSERT_EQ(sources.size(), 2u);
  EXPECT_LE(sources[0].end, 31);
  EXPECT_GE(sources[1].start, 69);
}

TEST(SidewalkSources, AKerbThatRunsAwayFromItsAxisIsMeasuredWhereItLies) {
  const auto sources = beside({{{{0, 8}, {100, 8}}, 0}}, {{0, true, 4, 8}});
  ASSERT_EQ(sources.size(), 1u);
  EXPECT_NEAR(sources[0].distance, 2, 0.1);
}

TEST(SidewalkSources, AFootwayThatKeepsItsDistanceHasNoCourse) {
  const auto sources = beside({{{{10, 6}, {50, 6.4}, {90, 6}}, 0}});
  ASSERT_EQ(sources.size(), 1u);
  EXPECT_TRUE(sources[0].course.empty());
}

TEST(SidewalkSources, AFootwayThatLeadsToACrossingAtItsEndKeepsItsCourse) {
  for (const Line& line : {Line{{10, 5}, {18, 8}, {90, 8}}, Line{{90, 5}, {82, 8}, {10, 8}}}) {
    const auto sources = beside({{line, 0}});
    ASSERT_EQ(sources.size(), 1u);
    EXPECT_TRUE(sources[0].course.empty());
  }
  // Farther from its end it does not.
  EXPECT_FALSE(beside({{{{10, 5}, {30, 5}, {38, 8}, {90, 8}}, 0}})[0].course.empty());
}

TEST(SidewalkSources, ACourseFollowsTheFootway) {
  std::mt19937 random(4812);
  std::uniform_real_distribution<double> aside(5, 12);
  for (int n = 0; n < 50; ++n) {
    Line line;
    for (int i = 0; i <= 4; ++i) line.push_back({10.0 + 20 * i, aside(random)});
    const auto sources = beside({{line, 0}}, {both_sides[0]});
    ASSERT_EQ(sources.size(), 1u);
    const auto& course = sources[0].course;
    if (course.empty()) continue;
    EXPECT_EQ(course.front().abscissa, sources[0].start);
    EXPECT_EQ(course.back().abscissa, sources[0].end);
    for (std::size_t c = 1; c < course.size(); ++c) {
      const auto& [from, near] = course[c - 1];
      const auto& [to, far] = course[c];
      ASSERT_LE(from, to);
      for (double at = std::ceil(from); at <= to; ++at) {
        std::size_t i = 0;
        while (line[i + 1].x < at) ++i;
        const double wanted = line[i].y + (line[i + 1].y - line[i].y) * (at - line[i].x) / 20 - 4;
        // Looks stand 2 m apart, and between them the line may have a vertex.
        const double given = near + (far - near) * (at - from) / (to - from);
        EXPECT_GT(given, wanted - 0.5 - 0.7);
        // It may lead to a crossing at its ends.
        if (at > 21 && at < 79) EXPECT_LT(given, wanted + 0.5 + 0.7);
      }
    }
  }
}

// Turned and shifted, all is the same; the mirror swaps the sides.
TEST(SidewalkSources, NothingDependsOnThePlace) {
  std::mt19937 random(48);
  std::uniform_real_distribution<double> anywhere(-15, 115), turn(0, 6.28);
  for (int n = 0; n < 200; ++n) {
    LevelLine footway;
    for (int i = 0; i < 4; ++i) footway.line.push_back({anywhere(random), anywhere(random) / 8});
    const double angle = turn(random);
    const auto turned = [&](Line line, bool mirrored) {
      for (Point& p : line) {
        const double y = mirrored ? -p.y : p.y;
        p = {p.x * std::cos(angle) - y * std::sin(angle) + 5e5,
             p.x * std::sin(angle) + y * std::cos(angle) + 6e6};
      }
      return line;
    };
    const auto plain = beside({footway});
    for (const bool mirrored : {false, true}) {
      std::vector<StreetSide> sides = both_sides;
      for (StreetSide& side : sides) side.left = side.left != mirrored;
      const auto moved = sidewalk_sources({{turned(street.line, mirrored), 0}}, sides,
                                          {{turned(footway.line, mirrored), 0}}, FootwayMatch{});
      ASSERT_EQ(moved.size(), plain.size());
      for (std::size_t i = 0; i < plain.size(); ++i) {
        EXPECT_EQ(moved[i].side, plain[i].side);
        EXPECT_NEAR(moved[i].start, plain[i].start, 1e-6);
        EXPECT_NEAR(moved[i].end, plain[i].end, 1e-6);
        EXPECT_NEAR(moved[i].distance, plain[i].distance, 1e-6);
      }
    }
  }
}

}  // namespace
}  // namespace streetgen
