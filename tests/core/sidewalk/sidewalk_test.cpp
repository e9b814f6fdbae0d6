#include "streetgen/sidewalk.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "geometry/geos.hpp"
#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "geometry/surface_union.hpp"
#include "rounds.hpp"
#include "sidewalk/strip.hpp"

namespace streetgen {
namespace sidewalk_test {

SidewalkKerb kerb(const Line& line, std::optional<double> width) {
  SidewalkKerb made;
  made.line = line;
  made.width = width;
  return made;
}

const Sidewalk& of_kerb(const std::vector<Sidewalk>& sidewalks, int kerb) {
  for (const Sidewalk& sidewalk : sidewalks)
    if (sidewalk.kerb == kerb) return sidewalk;
  static const Sidewalk none;
  return none;
}

double total(const std::vector<Sidewalk>& sidewalks) {
  double sum = 0;
  for (const Sidewalk& sidewalk : sidewalks) sum += area(sidewalk.surface);
  return sum;
}

// The chords of a quarter circle about a centre, counter-clockwise from an angle.
Line quarter(const Point& centre, double radius, double from) {
  Line line;
  for (int i = 0; i <= 64; ++i) {
    const double t = from + M_PI_2 * i / 64;
    line.push_back({centre.x + radius * std::cos(t), centre.y + radius * std::sin(t), 0});
  }
  return line;
}

TEST(Sidewalk, OfAStraightKerbIsAsWideAsWanted) {
  const auto sidewalks = find_sidewalks({kerb({{0, 0, 0}, {40, 0, 0}}, 2.5)}, 5);
  ASSERT_EQ(sidewalks.size(), 1u);
  EXPECT_NEAR(area(sidewalks[0].surface), 100, 1e-9);
  EXPECT_TRUE(inside({20, 1, 0}, sidewalks[0].surface));
  EXPECT_EQ(sidewalks[0].method, Method::hypothesis);
}

TEST(Sidewalk, IsNoneWithoutWidth) {
  EXPECT_TRUE(find_sidewalks({kerb({{0, 0, 0}, {40, 0, 0}}, 0)}, 5).empty());
  EXPECT_TRUE(find_sidewalks({kerb({{0, 0, 0}, {40, 0, 0}}, std::nullopt)}, 5).empty());
}

TEST(Sidewalk, ChangesItsWidthAlongAKerbWithACourse) {
  SidewalkKerb changing = kerb({{0, 0, 0}, {40, 0, 0}}, 3);
  // Beyond its start the width is known as well: 1 m there, and 2 at the start.
  changing.course = {{-0.5, 1}, {0.5, 3}, {1, 3}};
  const auto sidewalks = find_sidewalks({changing}, 5);
  ASSERT_EQ(sidewalks.size(), 1u);
  EXPECT_NEAR(area(sidewalks[0].surface), 20 * 2.5 + 20 * 3, 1e-9);
  EXPECT_TRUE(inside({0.1, 1.9, 0}, sidewalks[0].surface));
  EXPECT_FALSE(inside({0.1, 2.2, 0}, sidewalks[0].surface));
  EXPECT_DOUBLE_EQ(sidewalks[0].width, 2.75);
}

TEST(Sidewalk, ACornerLeadsFromTheEndOfACourse) {
  const Line down{{0, 50, 0}, {0, 6, 0}}, east{{6, 0, 0}, {60, 0, 0}};
  SidewalkKerb changing = kerb(down, 2);
  changing.course = {{0, 2}, {1, 4}};
  const auto sidewalks =
      find_sidewalks({changing, kerb(quarter({6, 6, 0}, 6, M_PI), std::nullopt), kerb(east, 4)}, 5);
  ASSERT_EQ(sidewalks.size(), 3u);
  EXPECT_NEAR(area(of_kerb(sidewalks, 0).surface), 44 * 3, 0.05);
  EXPECT_DOUBLE_EQ(of_kerb(sidewalks, 1).width, 4);
  EXPECT_NEAR(area(of_kerb(sidewalks, 2).surface), 54 * 4, 0.1);
}

// The width changes to that of the next kerb over the last 2.5 m, and the course before stays.
TEST(Sidewalk, ACourseStaysBesideAChangeOfWidth) {
  SidewalkKerb changing = kerb({{0, 0, 0}, {40, 0, 0}}, 3);
  changing.course = {{0, 2}, {0.25, 4}, {0.75, 2}, {1, 2}};
  const SidewalkKerb next = kerb({{40, 0, 0}, {80, 0, 0}}, 3);
  const auto sidewalks = find_sidewalks({changing, next}, 5);
  EXPECT_NEAR(area(of_kerb(sidewalks, 0).surface), 10 * 3 + 20 * 3 + 7.5 * 2 + 2.5 * (2 + 2.5) / 2,
              1e-9);
  const SidewalkKerb before = kerb({{-40, 0, 0}, {0, 0, 0}}, 3);
  EXPECT_NEAR(area(of_kerb(find_sidewalks({before, changing}, 5), 1).surface),
              2.5 * (2.5 + 2.5) / 2 + 7.5 * (2.5 + 4) / 2 + 20 * 3 + 10 * 2, 1e-9);
}

// A block's corner: down, round to the left by an arc of radius 6, and east; 2 and 4 m wide.
TEST(Sidewalk, ChangesItsWidthAlongTheArcOfACorner) {
  const Line down{{0, 50, 0}, {0, 6, 0}}, east{{6, 0, 0}, {60, 0, 0}};
  const Line arc = quarter({6, 6, 0}, 6, M_PI);
  const auto sidewalks = find_sidewalks({kerb(down, 2), kerb(arc, std::nullopt), kerb(east, 4)}, 5);
  ASSERT_EQ(sidewalks.size(), 3u);
  EXPECT_NEAR(area(of_kerb(sidewalks, 0).surface), 44 * 2, 0.05);
  EXPECT_NEAR(area(of_kerb(sidewalks, 2).surface), 54 * 4, 0.1);
  EXPECT_DOUBLE_EQ(of_kerb(sidewalks, 1).width, 3);
  // A ring whose width goes from 2 to 4 m over 5 m in the middle of a quarter of radius 6.
  const double size = 6 * M_PI_2, flat = (size - 5) / 2;
  const double linear =
      flat * (2 - 4.0 / 12) + flat * (4 - 16.0 / 12) + 5 * (3 - (4 + 16 + 8) / 3.0 / 12);
  EXPECT_GT(area(of_kerb(sidewalks, 1).surface), linear - 0.05);
  // The straight back lines of the chords, 2 m wider in 5, meet up to 0.4 widths ahead: there the
  // sidewalk is wider by 0.4 times as much.
  const double ahead = 0.16 * 5 * (3 - (4 + 16 + 8) / 3.0 / 6);
  EXPECT_LT(area(of_kerb(sidewalks, 1).surface), linear + ahead);
}

// The back line turns with the kerb, and aside by the slope of the change where this begins and
// ends. It has no dent, whether the arc is wider than the sidewalks or not.
TEST(Sidewalk, HasASmoothBackWhereItsWidthChangesAlongAnArc) {
  for (const double radius : {1.0, 2.0, 3.0, 6.0, 15.0})
    for (const auto& [first, second] : {std::pair(3.0, 1.5), {1.5, 3.0}, {2.0, 3.5}, {3.0, 3.0}}) {
      const Line down{{0, 50, 0}, {0, radius, 0}}, east{{radius, 0, 0}, {60, 0, 0}};
      const auto sidewalks = find_sidewalks(
          {kerb(down, first), kerb(quarter({radius, radius, 0}, radius, M_PI), std::nullopt),
           kerb(east, second)},
          5);
      ASSERT_EQ(sidewalks.size(), 3u);
      Geos geos;
      std::vector<MultiPolygon> all;
      for (const Sidewalk& sidewalk : sidewalks) all.push_back(sidewalk.surface);
      const MultiPolygon ground = united(geos, all);
      ASSERT_EQ(ground.size(), 1u) << radius << ": " << first << " to " << second;
      EXPECT_NEAR(total(sidewalks), area(ground), 1e-6);
      double aside = 0, together = 0;
      const Ring& ring = ground[0][0];
      const double way = signed_area(ring) > 0 ? 1 : -1;
      for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
        const Point &before = ring[i - 1], &at = ring[i], &after = ring[i + 1];
        const bool on_arc = std::abs(distance(at, {radius, radius, 0}) - radius) < 1e-3 &&
                            std::max(at.x, at.y) <= radius;
        if (on_arc || std::min(at.x, at.y) < 0.5 || std::max(at.x, at.y) > 40) continue;
        const double turn =
            way * std::atan2(cross(at - before, after - at), dot(at - before, after - at));
        together += turn;
        aside += std::max(turn, 0.0);
      }
      // A ring about the ground walks its back against the kerb: inner bends turn clockwise.
      EXPECT_NEAR(together, -M_PI_2, 1e-6) << radius << ": " << first << " to " << second;
      EXPECT_LT(aside, std::atan(std::abs(first - second) / 5) + 1e-6)
          << radius << ": " << first << " to " << second;
    }
}

// Each side is as wide as wanted up to where the two back lines meet.
TEST(Sidewalk, OfATightArcMeetsAtTheCornerOfTheTwoBackLines) {
  const Line down{{0, 50, 0}, {0, 2, 0}}, east{{2, 0, 0}, {60, 0, 0}};
  const auto sidewalks = find_sidewalks(
      {kerb(down, 3), kerb(quarter({2, 2, 0}, 2, M_PI), std::nullopt), kerb(east, 3)}, 5);
  ASSERT_EQ(sidewalks.size(), 3u);
  // The place where both are 3 m away lies 1 m beyond the centre of the arc. Bisectors between the
  // arc and its tangents lean by a quarter of the angle of a chord.
  EXPECT_NEAR(area(of_kerb(sidewalks, 0).surface), 47 * 3 + 1 * 2.5, 0.02);
  EXPECT_NEAR(area(of_kerb(sidewalks, 1).surface), M_PI, 0.03);
  EXPECT_NEAR(area(of_kerb(sidewalks, 2).surface), 57 * 3 + 1 * 2.5, 0.02);
  for (const Sidewalk& sidewalk : sidewalks) EXPECT_EQ(sidewalk.method, Method::hypothesis);
}

// Half of the transition lies before the meeting of the two kerbs, and half behind.
TEST(Sidewalk, ChangesItsWidthAboutAPlaneMeetingOfTwoKerbs) {
  const auto sidewalks =
      find_sidewalks({kerb({{0, 0, 0}, {40, 0, 0}}, 2), kerb({{40, 0, 0}, {80, 0, 0}}, 4)}, 5);
  EXPECT_NEAR(area(of_kerb(sidewalks, 0).surface), 37.5 * 2 + 2.5 * 2.5, 1e-9);
  EXPECT_NEAR(area(of_kerb(sidewalks, 1).surface), 37.5 * 4 + 2.5 * 3.5, 1e-9);
}

// The width goes from 2 to 1.5 m over 5 m, of which the last 0.1 m lie on a kerb of 2 m. The
// sidewalk ends square at the kerb that has none.
TEST(Sidewalk, ChangesItsWidthTwiceAlongAShortKerbWhateverTheOrderOfKerbs) {
  const std::vector<SidewalkKerb> kerbs{
      kerb({{0, 0, 0}, {40, 0, 0}}, 2), kerb({{40, 0, 0}, {44.8, 0, 0}}, std::nullopt),
      kerb({{44.8, 0, 0}, {46.8, 0, 0}}, 1.5), kerb({{46.8, 0, 0}, {60, 0, 0}}, 0)};
  const double wanted = 0.1 * (1.51 + 1.5) / 2 + 1.9 * 1.5;
  std::vector<int> order{0, 1, 2, 3};
  do {
    std::vector<SidewalkKerb> given;
    for (const int i : order) given.push_back(kerbs[i]);
    const int at = static_cast<int>(std::find(order.begin(), order.end(), 2) - order.begin());
    EXPECT_NEAR(area(of_kerb(find_sidewalks(given, 5), at).surface), wanted, 1e-9);
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(Sidewalk, EndsSquareAtAKerbWithoutWidthThatGoesStraightOn) {
  const auto sidewalks =
      find_sidewalks({kerb({{0, 0, 0}, {40, 0, 0}}, 0), kerb({{40, 0, 0}, {80, 0, 0}}, 4)}, 5);
  ASSERT_EQ(sidewalks.size(), 1u);
  EXPECT_NEAR(area(sidewalks[0].surface), 160, 1e-9);
}

// A kerb comes down, turns to the left by an arc and leads on without a sidewalk. The back line
// goes straight on, to where the arc or the kerb behind it meets it.
TEST(Sidewalk, GoesStraightOnToTheKerbOfAStreetThatHasNone) {
  for (const double radius : {0.5, 2.0, 6.0, 12.0})
    for (const double width : {1.5, 3.0})
      for (const bool mirrored : {false, true}) {
        std::vector<SidewalkKerb> kerbs{
            kerb({{0, 50, 0}, {0, radius, 0}}, width),
            kerb(quarter({radius, radius, 0}, radius, M_PI), std::nullopt),
            kerb({{radius, 0, 0}, {60, 0, 0}}, 0)};
        if (mirrored)
          for (SidewalkKerb& each : kerbs) {
            for (Point& place : each.line) place.x = -place.x;
            std::reverse(each.line.begin(), each.line.end());
          }
        const auto sidewalks = find_sidewalks(kerbs, 5);
        ASSERT_EQ(sidewalks.size(), 2u) << radius << ' ' << width;
        EXPECT_NEAR(area(of_kerb(sidewalks, 0).surface), (50 - radius) * width, 1e-6);
        EXPECT_EQ(of_kerb(sidewalks, 1).method, Method::hypothesis);
        EXPECT_DOUBLE_EQ(of_kerb(sidewalks, 1).width, width);
        // All between the arc and the line `width` from the kerb that comes down: the integral of
        // the depth of the arc, and a rectangle where the line lies beyond it.
        const double rest = std::max(radius - width, 0.0), across = std::min(width, radius);
        const double under =
            radius * radius * std::acos(rest / radius) - rest * std::sqrt(across * (radius + rest));
        const double wanted = under / 2 + (width - across) * radius;
        EXPECT_NEAR(area(of_kerb(sidewalks, 1).surface), wanted, 1e-3 * radius * radius)
            << radius << ' ' << width;
      }
}

// A corner whose kerb comes in pieces: straight ones before and behind its arc, of millimetres
// where the street is slanted by as much, of metres where its own sections have no ground.
TEST(Sidewalk, LeadsOnAlongTheStreetToTheCornerOfOneThatHasNone) {
  const double radius = 6, width = 3;
  for (const double piece : {0.004, 0.5, 10.0})
    for (const bool mirrored : {false, true}) {
      std::vector<SidewalkKerb> kerbs{
          kerb({{0, 50, 0}, {0, radius + piece, 0}}, width),
          kerb({{0, radius + piece, 0}, {0, radius, 0}}, std::nullopt),
          kerb(quarter({radius, radius, 0}, radius, M_PI), std::nullopt),
          kerb({{radius, 0, 0}, {radius + piece, 0, 0}}, std::nullopt),
          kerb({{radius + piece, 0, 0}, {60, 0, 0}}, 0)};
      if (mirrored)
        for (SidewalkKerb& each : kerbs) {
          for (Point& place : each.line) place.x = -place.x;
          std::reverse(each.line.begin(), each.line.end());
        }
      const auto sidewalks = find_sidewalks(kerbs, 5);
      ASSERT_EQ(sidewalks.size(), 3u) << piece;
      EXPECT_DOUBLE_EQ(of_kerb(sidewalks, 1).width, width);
      EXPECT_NEAR(area(of_kerb(sidewalks, 1).surface), piece * width, 1e-6) << piece;
      // Half of a segment of the circle, as deep as the sidewalk is wide.
      const double rest = radius - width;
      const double segment = radius * radius * std::acos(rest / radius) -
                             rest * std::sqrt(radius * radius - rest * rest);
      EXPECT_NEAR(area(of_kerb(sidewalks, 2).surface), segment / 2, 0.04) << piece;
      EXPECT_EQ(of_kerb(sidewalks, 2).method, Method::hypothesis);
    }
}

// A street parts by 10 degrees: the back line would meet its kerb only after 17 m.
TEST(Sidewalk, EndsSquareWhereAStreetThatHasNonePartsSlowly) {
  const double t = 10 * M_PI / 180;
  const auto sidewalks = find_sidewalks(
      {kerb({{0, 0, 0}, {40, 0, 0}}, 3), kerb({{40, 0, 0}, {42, 0, 0}}, std::nullopt),
       kerb({{42, 0, 0}, {42 + 40 * std::cos(t), 40 * std::sin(t), 0}}, 0)},
      5);
  EXPECT_NEAR(total(sidewalks), 42 * 3, 1e-9);
}

// The kerb turns back by 150 degrees, so the tip of the ground is narrower than the sidewalk.
TEST(Sidewalk, FillsTheTipOfASharpCornerWithAStreetThatHasNone) {
  const double t = 30 * M_PI / 180;
  const auto sidewalks = find_sidewalks(
      {kerb({{0, 0, 0}, {40, 0, 0}}, 3), kerb({{40, 0, 0}, {41, 0, 0}}, std::nullopt),
       kerb({{41, 0, 0}, {41 - 40 * std::cos(t), 40 * std::sin(t), 0}}, 0)},
      5);
  EXPECT_NEAR(area(of_kerb(sidewalks, 1).surface), std::tan(t) / 2, 1e-6);
  // Straight on, from the tip to the kerb that comes back.
  EXPECT_NEAR(total(sidewalks), 3 * 41 - 9 / std::tan(t) / 2, 1e-6);
}

// A street without a sidewalk on its right.
TEST(Sidewalk, EndsSquareAtADeadEndWhereTheOtherSideHasNone) {
  std::vector<SidewalkKerb> kerbs{kerb({{0, 0, 0}, {40, 0, 0}}, 3),
                                  kerb({{40, 0, 0}, {40, -6, 0}}, std::nullopt),
                                  kerb({{40, -6, 0}, {0, -6, 0}}, 0)};
  kerbs[1].across = true;
  EXPECT_NEAR(total(find_sidewalks(kerbs, 5)), 120, 1e-9);
  kerbs[2].width = 3;
  EXPECT_GT(total(find_sidewalks(kerbs, 5)), 240 + 18);
}

TEST(Sidewalk, GoesRoundAnOuterBendOnce) {
  const auto sidewalks =
      find_sidewalks({kerb({{0, 0, 0}, {20, 0, 0}}, 2), kerb({{20, 0, 0}, {20, -20, 0}}, 2)}, 5);
  EXPECT_NEAR(total(sidewalks), 2 * 20 * 2 + 8 * std::sin(M_PI / 16) * 4 / 2, 1e-9);
}

// Whichever way the kerbs are walked along, also where one goes to and fro and its strip is made of
// pieces.
TEST(Sidewalk, IsHalvedInTheMiddleOfAnOuterBend) {
  const double half = 8 * std::sin(M_PI / 16) * 4 / 4;
  const Line north{{0, 0, 0}, {20, 0, 0}}, east{{20, 0, 0}, {20, -20, 0}};
  const Line jagged{{0, 0, 0}, {10, 0, 0}, {10, 1, 0}, {10.5, 1, 0}, {10.5, 0, 0}, {20, 0, 0}};
  const auto plain = find_sidewalks({kerb(north, 2), kerb(east, 2)}, 5);
  EXPECT_NEAR(area(of_kerb(plain, 0).surface), 20 * 2 + half, 1e-9);
  EXPECT_NEAR(area(of_kerb(plain, 1).surface), 20 * 2 + half, 1e-9);
  const auto mirrored = [](Line line) {
    for (Point& p : line) p.x = -p.x;
    return reversed(line);
  };
  for (const Line& first : {north, jagged}) {
    const auto one = find_sidewalks({kerb(first, 2), kerb(east, 2)}, 5);
    const auto other = find_sidewalks({kerb(mirrored(east), 2), kerb(mirrored(first), 2)}, 5);
    for (int k = 0; k < 2; ++k)
      EXPECT_NEAR(area(of_kerb(one, k).surface), area(of_kerb(other, 1 - k).surface), 1e-6);
  }
}

// The border between two kerbs that bend goes by places on them, wherever their lines begin.
TEST(Sidewalk, BetweenTwoRoundKerbsIsTheSameInTheMirror) {
  const auto chords = [](const Line& line) {
    return Line{line[0], line[17], line[29], line[47], line[64]};
  };
  const auto mirrored = [](Line line) {
    for (Point& p : line) p.x = -p.x;
    return reversed(line);
  };
  const Line inner = reversed(chords(quarter({0, 0, 0}, 20.3, 0))),
             outer = chords(quarter({2, 1, 0}, 24.1, 0));
  const auto one = find_sidewalks({kerb(inner, 4), kerb(outer, 4)}, 5);
  const auto other = find_sidewalks({kerb(mirrored(inner), 4), kerb(mirrored(outer), 4)}, 5);
  EXPECT_EQ(of_kerb(one, 0).method, Method::contested);
  for (int k = 0; k < 2; ++k)
    EXPECT_NEAR(area(of_kerb(one, k).surface), area(of_kerb(other, k).surface), 1e-6);
}

Line moved(Line line, double turn, bool mirrored) {
  for (Point& p : line) {
    const double x = (mirrored ? -1 : 1) * (p.x - 6.5e5), y = p.y - 6.86e6;
    p = {6.5e5 + std::cos(turn) * x - std::sin(turn) * y,
         6.86e6 + std::sin(turn) * x + std::cos(turn) * y, 0};
  }
  return mirrored ? reversed(line) : line;
}

// The greatest change of an area in square metres, on moved paper and walked about the other way.
double most_changed_when_moved(const std::vector<SidewalkKerb>& kerbs) {
  const auto sidewalks = find_sidewalks(kerbs, 5);
  double most = 0;
  for (int k = 1; k < 8; ++k) {
    std::vector<SidewalkKerb> placed = kerbs;
    for (SidewalkKerb& kerb : placed) kerb.line = moved(kerb.line, k * 0.79, k % 2 == 1);
    const auto others = find_sidewalks(placed, 5);
    for (int i = 0; i < static_cast<int>(kerbs.size()); ++i)
      most = std::max(
          most, std::abs(area(of_kerb(sidewalks, i).surface) - area(of_kerb(others, i).surface)));
  }
  return most;
}

Line placed(Line line) {
  for (Point& p : line) p = p + Point{6.5e5, 6.86e6, 0};
  return line;
}

// Random narrow blocks, whose kerbs follow each other straight on and at corners. In one of twenty
// the fronts meet in a place where rounding tells which parts of which.
TEST(Sidewalk, OfANarrowBlockIsTheSameHoweverThePaperLies) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0, 1);
  int changed = 0;
  for (int round = 0; round < rounds(60); ++round) {
    const int corners = 3 + static_cast<int>(share(random) * 5);
    Line block;
    for (int i = 0; i < corners; ++i) {
      const double t = 2 * M_PI * (i + 0.6 * share(random)) / corners, r = 10 + 20 * share(random);
      block.push_back({r * std::cos(t), 0.3 * r * std::sin(t), 0});
    }
    block.push_back(block.front());
    std::vector<SidewalkKerb> kerbs;
    for (int i = 0; i < corners; ++i) {
      const Point from = block[i], to = block[i + 1];
      const Point between = from + (to - from) * (0.1 + 0.8 * share(random));
      const double width = 1 + 4 * share(random);
      kerbs.push_back(kerb(placed({from, between}), width));
      kerbs.push_back(kerb(placed({between, to}), width));
    }
    const double most = most_changed_when_moved(kerbs);
    EXPECT_LT(most, 0.02) << round;
    changed += most > 1e-6;
  }
  EXPECT_LE(changed, rounds(60) / 20);
}

// The kerb goes about a needle of ground and on round a bend.
TEST(Sidewalk, PassesANeedleAlikeInTheMirror) {
  const Line before = placed({{-20, 0, 0}, {0, 0, 0}, {0.09, -0.02, 0}});
  const Line back = placed({{0.09, -0.02, 0}, {0, 0.018, 0}});
  const Line after = placed({{0, 0.018, 0}, {0.3, -0.09, 0}, {0.4, 0.4, 0}, {1.2, 2.4, 0}});
  EXPECT_LT(most_changed_when_moved({kerb(before, 2), kerb(back, 2), kerb(after, 2)}), 1e-6);
}

// Two kerbs at a right angle without an arc: each square metre of the corner goes to the nearer.
TEST(Sidewalk, OfASharpInnerBendIsHalvedByTheBisector) {
  const auto sidewalks =
      find_sidewalks({kerb({{0, 40, 0}, {0, 0, 0}}, 3), kerb({{0, 0, 0}, {40, 0, 0}}, 3)}, 5);
  EXPECT_NEAR(area(of_kerb(sidewalks, 0).surface), 40 * 3 - 4.5, 0.1);
  EXPECT_NEAR(area(of_kerb(sidewalks, 1).surface), 40 * 3 - 4.5, 0.1);
  EXPECT_NEAR(total(sidewalks), 2 * 40 * 3 - 9, 1e-3);
}

// A block 4 m wide between two streets whose sidewalks want 3 m each.
TEST(Sidewalk, OfANarrowBlockIsHalvedBetweenItsKerbs) {
  const auto sidewalks =
      find_sidewalks({kerb({{0, 0, 0}, {50, 0, 0}}, 3), kerb({{50, 4, 0}, {0, 4, 0}}, 3)}, 5);
  EXPECT_NEAR(area(of_kerb(sidewalks, 0).surface), 100, 0.5);
  EXPECT_NEAR(area(of_kerb(sidewalks, 1).surface), 100, 0.5);
  EXPECT_NEAR(total(sidewalks), 200, 1e-3);
  EXPECT_EQ(of_kerb(sidewalks, 0).method, Method::contested);
}

// The vertices of each lie on its own kerb and on one line halfway, also where the kerbs converge.
TEST(Sidewalk, OfANarrowBlockEndsAtAStraightLineHalfway) {
  for (const double rise : {0.0, 2.5}) {
    const Line across{{50, 5.3 - rise, 0}, {0, 5.3, 0}};
    const auto sidewalks = find_sidewalks({kerb({{0, 0, 0}, {50, 0, 0}}, 4), kerb(across, 4)}, 5);
    for (const Point& place : of_kerb(sidewalks, 0).surface.at(0)[0]) {
      const double away = distance_to_line(place, across);
      EXPECT_TRUE(std::abs(place.y) < 1e-6 || std::abs(place.y - away) < 1e-3 || place.x < 1 ||
                  place.x > 49)
          << place.x << ' ' << place.y << ' ' << away;
    }
  }
}

// The fronts of its kerbs meet between the ends of all of them first.
TEST(Sidewalk, OfABlockThatIsNarrowestInItsMiddleIsHalved) {
  const Line ring{{0, 0, 0},    {100, 0, 0},  {100, 3.6, 0}, {75, 3.4, 0},
                  {50, 3.2, 0}, {25, 3.4, 0}, {0, 3.6, 0},   {0, 0, 0}};
  std::vector<SidewalkKerb> kerbs;
  for (std::size_t i = 1; i < ring.size(); ++i) kerbs.push_back(kerb({ring[i - 1], ring[i]}, 2.5));
  const auto sidewalks = find_sidewalks(kerbs, 5);
  EXPECT_NEAR(total(sidewalks), 340, 1e-3);
  for (const int above : {3, 4}) {
    EXPECT_NEAR(area(of_kerb(sidewalks, above).surface), 25 * 3.3 / 2, 0.1);
    EXPECT_EQ(of_kerb(sidewalks, above).method, Method::contested);
  }
}

// A dead end, and the kerb after it that leads around and past it again, 7 cm off.
TEST(Sidewalk, OfADeadEndStaysOffTheKerbThatComesByOnceMore) {
  const Line around{{-2.26, 2.78, 0}, {11.1, 32, 0},    {8, 38, 0},
                    {-5, 10.8, 0},    {-5.95, 6.16, 0}, {16.66, -15.16, 0}};
  const auto sidewalks =
      find_sidewalks({kerb({{16.6, 29.7, 0}, {3.2, 0.29, 0}}, 1.5),
                      kerb({{3.2, 0.29, 0}, {-2.26, 2.78, 0}}, std::nullopt), kerb(around, 1.5)},
                     5);
  const Point &from = around[4], &to = around[5];
  const Sidewalk& end = of_kerb(sidewalks, 1);
  EXPECT_GT(area(end.surface), 2);
  for (const Point& place : end.surface.at(0)[0])
    EXPECT_GT(cross(to - from, place - from), -1e-3 * distance(from, to))
        << place.x << ' ' << place.y;
}

// The same between kerbs that follow each other about the block.
TEST(Sidewalk, OfANarrowBlockIsHalvedBetweenKerbsOfOneRing) {
  const Line ring{{0, 0, 0}, {50, 0, 0}, {50, 4, 0}, {0, 4, 0}, {0, 0, 0}};
  std::vector<SidewalkKerb> kerbs;
  for (int i = 0; i < 4; ++i) kerbs.push_back(kerb({ring[i], ring[i + 1]}, 3));
  const auto sidewalks = find_sidewalks(kerbs, 5);
  EXPECT_NEAR(total(sidewalks), 200, 1e-6);
  EXPECT_NEAR(area(of_kerb(sidewalks, 0).surface), (50 + 46) / 2.0 * 2, 1e-6);
  EXPECT_NEAR(area(of_kerb(sidewalks, 1).surface), 4, 1e-6);
  EXPECT_EQ(of_kerb(sidewalks, 0).method, Method::contested);
  kerbs[2].width = 1;
  const auto uneven = find_sidewalks(kerbs, 5);
  EXPECT_NEAR(total(uneven), 200, 1e-3);
  EXPECT_GT(area(of_kerb(uneven, 0).surface), 40 * 3);
}

TEST(Sidewalk, EndsAtTheKerbAcrossANarrowBlock) {
  for (const double across : {0.0, 0.5}) {
    const auto sidewalks = find_sidewalks(
        {kerb({{0, 0, 0}, {50, 0, 0}}, 5), kerb({{60, 2, 0}, {-10, 2, 0}}, across)}, 5);
    const double strip = across * 20;  // beside the other kerb alone
    EXPECT_NEAR(total(sidewalks), 100 + strip, 0.01);
    EXPECT_NEAR(area(of_kerb(sidewalks, 0).surface), 50 * (2 - across), 0.01);
  }
}

// The sidewalk of the kerb across narrows to nothing before it comes there.
TEST(Sidewalk, EndsAtTheKerbAcrossWhereThatHasNone) {
  const auto sidewalks = find_sidewalks(
      {kerb({{0, 0, 0}, {20, 0, 0}}, 3), kerb({{60, 60, 0}, {60, 1, 0}}, 3),
       kerb({{60, 1, 0}, {-10, 1, 0}}, std::nullopt), kerb({{-10, 1, 0}, {-30, 1, 0}}, 0)},
      5);
  EXPECT_NEAR(area(of_kerb(sidewalks, 0).surface), 20, 0.01);
}

TEST(Sidewalk, IsNotTouchedByAKerbOfAnotherLevel) {
  std::vector<SidewalkKerb> kerbs{kerb({{0, 0, 0}, {50, 0, 0}}, 3),
                                  kerb({{20, -9, 0}, {20, 9, 0}}, 3)};
  kerbs[1].level = 1;
  const auto sidewalks = find_sidewalks(kerbs, 5);
  EXPECT_NEAR(total(sidewalks), 150 + 54, 1e-9);
}

// The kerb of an island, clockwise about its roadway: the island lies on its left.
TEST(Sidewalk, FillsAnIslandThatIsNarrowerThanTwoOfThem) {
  std::vector<SidewalkKerb> kerbs;
  const Line ring{{0, 0, 0}, {20, 0, 0}, {20, 3, 0}, {0, 3, 0}, {0, 0, 0}};
  kerbs.push_back(kerb(ring, 2));
  EXPECT_NEAR(total(find_sidewalks(kerbs, 5)), 60, 0.01);
}

TEST(Sidewalk, ComesOutOfWantedKerbsAlone) {
  std::vector<SidewalkKerb> kerbs{kerb({{0, 0, 0}, {50, 0, 0}}, 3),
                                  kerb({{50, 4, 0}, {0, 4, 0}}, 3)};
  kerbs[1].wanted = false;
  const auto sidewalks = find_sidewalks(kerbs, 5);
  ASSERT_EQ(sidewalks.size(), 1u);
  EXPECT_NEAR(area(sidewalks[0].surface), 100, 0.5);
}

// Random blocks: rings of kerbs with corners of any kind, turned and in any place.
TEST(Sidewalk, OfRandomBlocksLieInsideAndOverlapNowhere) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0, 1);
  Geos geos;
  for (int round = 0; round < rounds(200); ++round) {
    const int corners = 3 + static_cast<int>(share(random) * 6);
    Line block;
    for (int i = 0; i < corners; ++i) {
      const double t = 2 * M_PI * (i + 0.6 * share(random)) / corners, r = 4 + 40 * share(random);
      block.push_back({6.5e5 + r * std::cos(t), 6.86e6 + r * std::sin(t), 0});
    }
    block.push_back(block.front());
    std::vector<SidewalkKerb> kerbs;
    for (int i = 0; i < corners; ++i)
      kerbs.push_back(kerb({block[i], block[i + 1]}, share(random) < 0.2 ? 0 : 6 * share(random)));
    const auto sidewalks = find_sidewalks(kerbs, 5);
    const MultiPolygon ground{{block}};
    std::vector<MultiPolygon> all{ground};
    double sum = 0;
    for (const Sidewalk& sidewalk : sidewalks) {
      EXPECT_TRUE(geos.valid(sidewalk.surface)) << round;
      all.push_back(sidewalk.surface);
      sum += area(sidewalk.surface);
      double within = 0;
      for (const Point& p : sidewalk.surface[0][0])
        if (!inside(p, ground)) within = std::max(within, distance_to_line(p, block));
      EXPECT_LT(within, 1e-3) << round;
    }
    EXPECT_NEAR(area(geos.polygons(geos.unite(all).get())), area(ground), 1e-4 * area(ground))
        << round;
    all.erase(all.begin());
    EXPECT_NEAR(area(geos.polygons(geos.unite(all).get())), sum, 1e-4 * area(ground)) << round;
  }
}

// What is contested at the far end of the next kerb is none of its business.
TEST(Sidewalk, EndsAtTheBisectorWhateverTheNextKerbMeetsFartherOn) {
  const SidewalkKerb first = kerb({{0.3, -7.1, 0}, {20, 0, 0}}, 2);
  const SidewalkKerb next = kerb({{20, 0, 0}, {20, 60, 0}}, 3);
  const SidewalkKerb across = kerb({{20, 60, 0}, {17, 45, 0}}, 1);
  const SidewalkKerb beyond = kerb({{17, 45, 0}, {0, 45, 0}}, 1);
  const Sidewalk alone = of_kerb(find_sidewalks({first, next}, 0), 0);
  const auto all = find_sidewalks({first, next, across, beyond}, 0);
  const Sidewalk& beside = of_kerb(all, 0);
  EXPECT_EQ(of_kerb(all, 1).method, Method::contested);
  EXPECT_EQ(beside.method, Method::hypothesis);
  EXPECT_DOUBLE_EQ(area(beside.surface), area(alone.surface));
  Geos geos;
  std::vector<MultiPolygon> surfaces;
  for (const Sidewalk& sidewalk : all) surfaces.push_back(sidewalk.surface);
  EXPECT_NEAR(area(geos.polygons(geos.unite(surfaces).get())), total(all), 1e-6);
}

// The next kerb shrinks to nothing behind the strip, and its round bend stays its own.
TEST(Sidewalk, LeavesTheOuterBendToTheNextKerb) {
  const Line way{{-6.723, 23.704, 0}, {-17.580, 28.940, 0}, {-13.084, 14.309, 0},
                 {-8.692, 5.889, 0},  {-36.450, 19.648, 0}, {-14.309, 2.836, 0},
                 {-10.175, 0.233, 0}};
  const double widths[] = {1.037, 2.826, 1.67, 2.301, 2.583, 2.184};
  std::vector<SidewalkKerb> kerbs;
  for (int i = 0; i < 6; ++i) kerbs.push_back(kerb({way[i], way[i + 1]}, widths[i]));
  const double own = area(of_kerb(find_sidewalks(kerbs, 5), 2).surface);
  kerbs.resize(4);
  EXPECT_NEAR(own, area(of_kerb(find_sidewalks(kerbs, 5), 2).surface), 1e-6);
}

// Kerbs of contested ground may cross each other and themselves; no strip leaves its kerb for that.
TEST(Sidewalk, LiesNearItsKerbWhateverWayTheKerbsGo) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0, 1);
  for (int round = 0; round < rounds(300); ++round) {
    Line way{{6.5e5, 6.86e6, 0}};
    double heading = 0;
    for (int i = 0; i < 12; ++i) {
      heading += (share(random) - 0.5) * 5;
      const double size = 1 + 20 * share(random);
      way.push_back(
          {way.back().x + size * std::cos(heading), way.back().y + size * std::sin(heading), 0});
    }
    std::vector<SidewalkKerb> kerbs;
    for (int i = 0; i < 12; ++i) kerbs.push_back(kerb({way[i], way[i + 1]}, 1 + 2 * share(random)));
    const KerbChains chains(kerbs, 0);
    const std::vector<Strip> strips = strips_behind(kerbs, chains);
    for (int i = 0; i < 12; ++i)
      for (const Polygon& part : strips[i].surface)
        for (const Point& place : part[0])
          EXPECT_LE(distance_to_line(place, kerbs[i].line), 1.25 * 3 + 1e-6) << round << ' ' << i;
  }
}

std::vector<int> near(const std::vector<SidewalkKerb>& kerbs, const std::vector<int>& places) {
  std::vector<int> found;
  for (int j = 0; j < static_cast<int>(kerbs.size()); ++j)
    if (std::any_of(places.begin(), places.end(), [&](int i) {
          const Line &line = kerbs[j].line, &from = kerbs[i].line;
          return std::min({distance_to_line(line[0], from), distance_to_line(line[1], from),
                           distance_to_line(from[0], line), distance_to_line(from[1], line)}) <
                 2.5 * 3 + 0.01;
        }))
      found.push_back(j);
  return found;
}

// An edit gives the kerbs near those that it moved and the ones near these, a run all of them.
TEST(Sidewalk, IsTheSameWhicheverKerbsAreGivenFartherOff) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> share(0, 1);
  for (int round = 0; round < rounds(90); ++round) {
    const int corners = round % 3 == 0 ? 24 : 60;
    const double spike = 2 + round % 12;
    Line block;
    for (int i = 0; i <= corners; ++i) {
      const double t = 2 * M_PI * i / corners, r = 20 + spike * share(random);
      block.push_back({6.5e5 + r * std::cos(t), 6.86e6 + r * std::sin(t), 0});
    }
    block.back() = block.front();
    std::vector<SidewalkKerb> kerbs;
    for (int i = 0; i < corners; ++i)
      kerbs.push_back(kerb({block[i], block[i + 1]}, 1 + 2 * share(random)));
    const auto all = find_sidewalks(kerbs, 5);
    for (int i = 0; i < corners; ++i) {
      std::vector<SidewalkKerb> given;
      int own = -1;
      for (const int j : near(kerbs, near(kerbs, {i}))) {
        if (j == i) own = static_cast<int>(given.size());
        given.push_back(kerbs[j]);
      }
      const Sidewalk one = of_kerb(find_sidewalks(given, 5), own), &same = of_kerb(all, i);
      ASSERT_EQ(one.surface.size(), same.surface.size()) << round << ' ' << i;
      for (std::size_t p = 0; p < one.surface.size(); ++p) {
        const Ring &ring = one.surface[p][0], &other = same.surface[p][0];
        ASSERT_EQ(ring.size(), other.size()) << round << ' ' << i;
        for (std::size_t v = 0; v < ring.size(); ++v)
          EXPECT_TRUE(ring[v].x == other[v].x && ring[v].y == other[v].y) << round << ' ' << i;
      }
    }
  }
}

}  // namespace sidewalk_test
}  // namespace streetgen
