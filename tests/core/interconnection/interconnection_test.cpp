#include "streetgen/interconnection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <tuple>

#include "geometry/polyline.hpp"
#include "interconnection/joined_town.hpp"
#include "rounds.hpp"
#include "streetgen/trajectory.hpp"

namespace streetgen {
namespace interconnection_test {

TEST(Interconnection, PairsEveryLaneInWithEveryLaneOutOfAnotherEdge) {
  EXPECT_EQ(crossing(1).join().size(), 12u);
  EXPECT_EQ(crossing(2).join().size(), 48u);
}

TEST(Interconnection, UTurnPairsAlsoLanesOfOneEdge) {
  InterconnectionSettings settings;
  settings.u_turn = true;
  const JoinedTown town = crossing(1);
  const auto all = town.join({}, settings);
  // Four at the crossing, one at each of the four dead ends.
  EXPECT_EQ(all.size(), 12u + 4u + 4u);
  for (const Interconnection& i : all)
    if (town.lane(i.lane_in).edge == town.lane(i.lane_out).edge) {
      EXPECT_EQ(i.turn, Turn::u_turn);
    }
}

TEST(Interconnection, HasTheKindAndTheAngleOfItsTurn) {
  const JoinedTown town = crossing(1);
  const std::map<std::int64_t, std::pair<Turn, double>> expected{
      {2, {Turn::right, -90}}, {3, {Turn::through, 0}}, {4, {Turn::left, 90}}};
  for (const Interconnection& i : town.join()) {
    if (town.axis_of(i.lane_in) != 1) continue;
    const auto& [turn, angle] = expected.at(town.axis_of(i.lane_out));
    EXPECT_EQ(i.turn, turn);
    EXPECT_NEAR(i.angle, angle, 1e-9);
  }
}

TEST(Interconnection, StartsAndEndsOnItsLanes) {
  const JoinedTown town = crossing(2);
  for (const Interconnection& i : town.join()) {
    const Lane &in = town.lane(i.lane_in), &out = town.lane(i.lane_out);
    EXPECT_EQ(distance(i.line.front(), in.along_axis ? in.line.back() : in.line.front()), 0);
    EXPECT_EQ(distance(i.line.back(), out.along_axis ? out.line.front() : out.line.back()), 0);
  }
}

// As (from, to, along the axis of the one, of the other).
using Ways = std::set<std::tuple<std::int64_t, std::int64_t, bool, bool>>;
Ways ways(const JoinedTown& town, const std::vector<Interconnection>& all) {
  Ways found;
  for (const Interconnection& i : all)
    found.emplace(town.axis_of(i.lane_in), town.axis_of(i.lane_out), i.along_in, i.along_out);
  EXPECT_EQ(found.size(), all.size());
  return found;
}

TEST(Interconnection, ALaneForBothDirectionsComesInAndGoesOutAtBothEnds) {
  const Line middle{{0, 0, 0}, {90, 0, 0}}, onwards{{180, 0, 0}, {90, 0, 0}};
  const JoinedTown town({narrow(1, west), narrow(2, middle), road(3, onwards, 1, 1)});
  EXPECT_EQ(
      ways(town, town.join()),
      (Ways{{1, 2, true, true}, {2, 1, false, false}, {2, 3, true, false}, {3, 2, true, false}}));
  InterconnectionSettings settings;
  settings.u_turn = true;
  for (const Interconnection& i : town.join({}, settings)) {
    const bool back = town.lane(i.lane_in).edge == town.lane(i.lane_out).edge;
    const bool dead_end = std::abs(i.line.front().x - 40) > 130;
    EXPECT_EQ(i.plausible, !back || dead_end);
  }
}

TEST(Interconnection, LeavesALaneForBothDirectionsAsOneDrives) {
  for (const TrajectoryRule rule : {TrajectoryRule::bezier, TrajectoryRule::arcs}) {
    InterconnectionSettings settings;
    settings.rule = rule;
    const Line away{{0, 0, 0}, {0, -100, 0}};
    const JoinedTown town({narrow(1, west), narrow(2, away), narrow(3, east), narrow(4, north)});
    const auto all = town.join({}, settings);
    EXPECT_EQ(all.size(), 12u);
    for (const Interconnection& i : all) {
      const Line &in = town.lane(i.lane_in).line, &out = town.lane(i.lane_out).line;
      EXPECT_TRUE(i.plausible);
      EXPECT_EQ(distance(i.line.front(), i.along_in ? in.back() : in.front()), 0);
      EXPECT_EQ(distance(i.line.back(), i.along_out ? out.front() : out.back()), 0);
      // Towards the node, and away from it.
      const Point node{0, 0, 0}, &start = i.line.front(), &end = i.line.back();
      EXPECT_GT(dot(unit(i.line[1] - start), unit(node - start)), 0.95);
      EXPECT_GT(dot(unit(end - i.line[i.line.size() - 2]), unit(end - node)), 0.95);
    }
  }
}

TEST(Interconnection, TellsTheEndsOfALaneForBothDirectionsApart) {
  const Line upper{{0, 0, 0}, {50, 60, 0}, {100, 0, 0}},
      lower{{0, 0, 0}, {50, -60, 0}, {100, 0, 0}};
  const JoinedTown ring({narrow(1, upper), narrow(2, lower)});
  EXPECT_EQ(
      ways(ring, ring.join()),
      (Ways{{1, 2, true, false}, {2, 1, true, false}, {1, 2, false, true}, {2, 1, false, true}}));
  const Line loop{{0, 0, 0}, {60, -60, 0}, {120, 0, 0}, {60, 60, 0}, {0, 0, 0}};
  const JoinedTown lasso({narrow(1, west), narrow(2, loop)});
  const auto all = lasso.join();
  EXPECT_EQ(
      ways(lasso, all),
      (Ways{{1, 2, true, true}, {1, 2, true, false}, {2, 1, true, false}, {2, 1, false, false}}));
  for (const Interconnection& i : all) EXPECT_TRUE(i.plausible);
}

// Streets of 7 m, some nearly beside each other: the limits of these lie far from the node, and
// what curves at once from lane to lane cuts the corner to a third street.
TEST(Interconnection, StaysOnTheRoadwayOfAcuteCrossings) {
  for (const double narrow : {8., 12., 20., 35.})
    for (const double wide : {60., 90., 120., 150.}) {
      std::vector<LanedAxis> roads;
      double angle = 0;
      for (const double step : {0., narrow, wide, narrow}) {
        angle += step * M_PI / 180;
        roads.push_back(road(static_cast<std::int64_t>(roads.size()) + 1,
                             {{0, 0, 0}, {300 * std::cos(angle), 300 * std::sin(angle), 0}}, 1, 1));
      }
      const JoinedTown town(roads);
      for (const Interconnection& i : town.join())
        for (double at = 0.05; at < length(i.line); at += 0.1)
          EXPECT_TRUE(town.holds(position_at(i.line, at).point))
              << narrow << ' ' << wide << ' ' << at;
    }
}

// Tangents of a right turn about a kerb arc of 8 m are 8 + 3.5 / 2 m long; the parabola between
// them bends by no less than that length / sqrt(2) = 6.9 m.
TEST(Interconnection, ATurnIsAsWideAsTheKerbsAllow) {
  const JoinedTown town = crossing(1);
  InterconnectionSettings narrow;
  narrow.least_radius = 3;
  const auto wide = town.join(), least = town.join({}, narrow);
  ASSERT_EQ(wide.size(), least.size());
  int turns = 0;
  for (std::size_t i = 0; i < wide.size(); ++i) {
    EXPECT_GE(quarter_radius(wide[i].line), quarter_radius(least[i].line) - 1e-9);
    if (wide[i].turn != Turn::left && wide[i].turn != Turn::right) continue;
    ++turns;
    EXPECT_GE(quarter_radius(wide[i].line), 6.5) << turn_name(wide[i].turn);
  }
  EXPECT_GT(turns, 0);
}

// Streets come from both sides, so near to each other that their corners want the ground twice.
TEST(Interconnection, TurnsOfNearJunctionsShareTheGroundBetween) {
  for (const double apart : {12., 16., 20.})
    for (const bool backward : {false, true}) {
      Line between{{0, 0, 0}, {apart, 0, 0}};
      if (backward) between = reversed(between);
      const JoinedTown town({road(1, west, 1, 1), road(2, between, 1, 1),
                             road(3, {{apart, 0, 0}, {apart + 100, 0, 0}}, 1, 1),
                             road(4, north, 1, 1),
                             road(5, {{apart, 0, 0}, {apart, -100, 0}}, 1, 1)});
      int turns = 0;
      for (const Interconnection& i : town.join()) {
        if (!i.plausible || i.turn == Turn::through || i.turn == Turn::u_turn) continue;
        EXPECT_GT(quarter_radius(i.line), 3) << apart << ' ' << backward;
        ++turns;
      }
      EXPECT_EQ(turns, 8);
    }
}

TEST(Interconnection, APathThatTrafficTakesHasNoCorner) {
  int taken = 0, kept = 0, out = 0;
  for (int seed = 1; seed <= rounds(400); ++seed) {
    const JoinedTown town(LanedStar(seed).roads());
    for (const Interconnection& i : town.join()) {
      const bool corner = sharpest_turn(i.line) > 30;
      if (i.plausible) ++taken;
      if (i.plausible && corner) {
        EXPECT_EQ(i.reason, Reason::not_drivable) << seed;
        ++kept;
      }
      if (i.reason != Reason::not_drivable) continue;
      EXPECT_TRUE(corner) << seed;
      if (!i.plausible) ++out;
    }
  }
  EXPECT_GT(taken, rounds(1000));
  EXPECT_LT(kept + out, taken / 100);
}

}  // namespace interconnection_test
}  // namespace streetgen
