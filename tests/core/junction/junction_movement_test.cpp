#include "streetgen/junction_movement.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"
#include "interconnection/guided_path.hpp"
#include "streetgen/trajectory.hpp"

namespace streetgen {
namespace junction_movement_test {

// A street along x of two carriageways, 20 m apart, that a two-way street crosses: the lower one
// runs to the right, the upper one to the left.  Legs: lower in, lower out, upper in, upper out,
// the cross street below and above.
class DualCarriageway : public ::testing::Test {
 protected:
  DualCarriageway() {
    place.nodes = {{0, 0}, {0, 20}};
    leg(1, 0, {{-12, 4}, {-12, -4}});
    leg(2, 0, {{12, 4}, {12, -4}});
    leg(3, 1, {{12, 24}, {12, 16}});
    leg(4, 1, {{-12, 24}, {-12, 16}});
    leg(5, 0, {{-4, -12}, {4, -12}});
    leg(6, 1, {{-4, 32}, {4, 32}});
    lane(0, true, {{-50, 0}, {-12, 0}});
    lane(1, false, {{12, 0}, {50, 0}});
    lane(2, true, {{50, 20}, {12, 20}});
    lane(3, false, {{-12, 20}, {-50, 20}});
    lane(4, true, {{2, -50}, {2, -12}});
    lane(4, false, {{-2, -12}, {-2, -50}});
    lane(5, true, {{-2, 70}, {-2, 32}});
    lane(5, false, {{2, 32}, {2, 70}});
    place.inner.push_back({7, inside, 0, 1, true, true, -2, 2, {{0, 0}, {0, 20}}});
    place.surface = {{{{-12, -4}, {-4, -4},  {-4, -12}, {4, -12}, {4, -4}, {12, -4}, {12, 4},
                       {4, 4},    {4, 16},   {12, 16},  {12, 24}, {4, 24}, {4, 32},  {-4, 32},
                       {-4, 24},  {-12, 24}, {-12, 16}, {-4, 16}, {-4, 4}, {-12, 4}, {-12, -4}}}};
  }

  void leg(std::int64_t axis, int node, Line border) {
    place.legs.push_back({axis, static_cast<int>(place.legs.size()), node, 3, 50, false, border});
  }
  void lane(int leg, bool comes_in, Line line) {
    JunctionLane lane;
    lane.lane_id = static_cast<std::int64_t>(place.lanes.size()) + 1;
    lane.leg = leg;
    lane.comes_in = comes_in;
    lane.line = std::move(line);
    place.lanes.push_back(lane);
  }
  const JunctionMovement* between(const std::vector<JunctionMovement>& all, int in, int out) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const JunctionMovement& m) {
      return m.lane_in == in && m.lane_out == out;
    });
    return found == all.end() ? nullptr : &*found;
  }

  static constexpr int inside = 6;  // the edge between the carriageways
  JunctionPlace place;
  InterconnectionSettings settings;
};

double off_course(const Point& course, const Point& from, const Point& to) {
  return std::abs(std::atan2(cross(course, to - from), dot(course, to - from))) * 180 / M_PI;
}

TEST_F(DualCarriageway, EveryTurnIsOnePathFromLaneToLane) {
  const auto all = junction_movements(place, settings);
  for (const JunctionMovement& m : all) {
    const Line &in = place.lanes[m.lane_in].line, &out = place.lanes[m.lane_out].line;
    ASSERT_GE(m.line.size(), 2u);
    EXPECT_LE(distance(m.line.front(), in.back()), 1e-9);
    EXPECT_LE(distance(m.line.back(), out.front()), 1e-9);
    EXPECT_LE(off_course(in[1] - in[0], m.line[0], m.line[1]), 1e-6);
    EXPECT_LE(off_course(out[1] - out[0], *(m.line.end() - 2), m.line.back()), 1e-6);
    EXPECT_LE(sharpest_turn(m.line), 30);
  }
  // Left from the lower carriageway, over the edge inside.
  const JunctionMovement* left = between(all, 0, 7);
  ASSERT_NE(left, nullptr);
  EXPECT_EQ(left->turn, Turn::left);
  EXPECT_TRUE(left->plausible);
}

// The limits of both lanes crossed: one goes on 12 m behind where the other ends.
TEST_F(DualCarriageway, WhereNoPathIsClearNoneLeadsFarAstray) {
  place.lanes[0].line = {{-50, 0}, {6, 0}};
  place.lanes[1].line = {{-5, 0}, {50, -4}};
  place.surface = {{{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}, {-9, -9}},
                    {{-1, -1}, {-1, 1}, {1, 1}, {1, -1}, {-1, -1}}}};
  const auto all = junction_movements(place, settings);
  const JunctionMovement* through = between(all, 0, 1);
  ASSERT_NE(through, nullptr);
  EXPECT_LE(length(through->line), 22) << "there and back";
}

TEST_F(DualCarriageway, ATurnBackToTheOtherCarriagewayGoesAboutTheMedian) {
  const auto all = junction_movements(place, settings);
  const JunctionMovement* back = between(all, 0, 3);
  ASSERT_NE(back, nullptr);
  EXPECT_EQ(back->turn, Turn::u_turn);
  double farthest = -100;
  for (const Point& p : back->line) farthest = std::max(farthest, p.x);
  EXPECT_GT(farthest, -4);
}

// Without the cross street the edge inside leads from one carriageway into the other alone.
TEST_F(DualCarriageway, AnOpeningInTheMedianIsMeantForTurningBack) {
  EXPECT_FALSE(between(junction_movements(place, settings), 0, 3)->plausible);
  place.legs.resize(4);
  place.lanes.resize(4);
  const auto all = junction_movements(place, settings);
  for (const auto& [in, out] : {std::pair(0, 3), std::pair(2, 1)}) {
    ASSERT_NE(between(all, in, out), nullptr);
    EXPECT_TRUE(between(all, in, out)->plausible);
    EXPECT_EQ(between(all, in, out)->turn, Turn::u_turn);
  }
  EXPECT_TRUE(between(all, 0, 1)->plausible);
}

TEST_F(DualCarriageway, NobodyTurnsBackFromAStreetThatGoesRoundARoundabout) {
  EXPECT_EQ(between(junction_movements(place, settings), 0, 3)->reason, Reason::u_turn);
  place.legs[0].on_ring = true;
  EXPECT_NE(between(junction_movements(place, settings), 0, 3)->reason, Reason::u_turn);
}

TEST_F(DualCarriageway, NothingRunsAgainstAOneWayEdgeInside) {
  place.inner[0].against = false;
  const auto all = junction_movements(place, settings);
  EXPECT_EQ(between(all, 6, 5), nullptr);
  EXPECT_NE(between(all, 4, 7), nullptr);
}

TEST_F(DualCarriageway, ARestrictionAtOneNodeForbidsTheWholeTurn) {
  TurnRestriction no_left;
  no_left.from_axis = 1;
  no_left.to_axis = 7;
  no_left.via = {0, 0};
  place.restrictions.push_back(no_left);
  const auto all = junction_movements(place, settings);
  ASSERT_NE(between(all, 0, 7), nullptr);
  EXPECT_FALSE(between(all, 0, 7)->plausible);
  EXPECT_EQ(between(all, 0, 7)->reason, Reason::restriction);
  EXPECT_TRUE(between(all, 0, 1)->plausible);
}

TEST_F(DualCarriageway, ARestrictionOfATurnBindsThatTurn) {
  place.legs[4].axis_id = 7;  // the cross street is one axis, below the carriageway too
  TurnRestriction no_left;
  no_left.from_axis = 1;
  no_left.to_axis = 7;
  no_left.via = {0, 0};
  no_left.turn = Turn::left;
  place.restrictions.push_back(no_left);
  const auto all = junction_movements(place, settings);
  EXPECT_EQ(between(all, 0, 7)->reason, Reason::restriction);
  EXPECT_NE(between(all, 0, 5)->reason, Reason::restriction);
}

TEST_F(DualCarriageway, WhomARestrictionExceptsItDoesNotBind) {
  TurnRestriction no_left;
  no_left.from_axis = 1;
  no_left.to_axis = 7;
  no_left.via = {0, 0};
  no_left.except = {LaneKind::bus};
  place.restrictions.push_back(no_left);
  const auto all = junction_movements(place, settings);
  EXPECT_EQ(between(all, 0, 7)->reason, Reason::traffic);
  EXPECT_EQ(between(all, 0, 7)->traffic, LaneKinds().set(index_of(LaneKind::bus)));
  EXPECT_EQ(between(all, 0, 1)->traffic, LaneKinds().set(index_of(LaneKind::general)));
  place.lanes[0].kind = place.lanes[7].kind = LaneKind::bus;
  EXPECT_TRUE(between(junction_movements(place, settings), 0, 7)->plausible);
}

TEST_F(DualCarriageway, CarsDriveOnNoEdgeInsideThatIsForBuses) {
  for (InnerEdge& edge : place.inner)
    edge.along = edge.against = LaneKinds().set(index_of(LaneKind::bus));
  const auto all = junction_movements(place, settings);
  EXPECT_EQ(between(all, 0, 7)->traffic, LaneKinds().set(index_of(LaneKind::bus)));
  EXPECT_EQ(between(all, 0, 1)->traffic, LaneKinds().set(index_of(LaneKind::general)));
}

TEST_F(DualCarriageway, ARestrictionViaAnEdgeForbidsTheTurnOverIt) {
  place.way_restrictions.push_back({1, 4, {inside}});
  const auto all = junction_movements(place, settings);
  EXPECT_FALSE(between(all, 0, 3)->plausible);
  EXPECT_EQ(between(all, 0, 3)->reason, Reason::restriction);
  EXPECT_TRUE(between(all, 0, 7)->plausible);
  EXPECT_NE(between(all, 4, 3)->reason, Reason::restriction);
}

TEST_F(DualCarriageway, OneThatSaysOnlyForbidsAllElse) {
  place.way_restrictions.push_back({1, 6, {inside}, true});
  const auto all = junction_movements(place, settings);
  EXPECT_TRUE(between(all, 0, 7)->plausible);
  for (const int out : {1, 3, 5}) EXPECT_EQ(between(all, 0, out)->reason, Reason::restriction);
  for (const int out : {1, 3, 7}) EXPECT_NE(between(all, 4, out)->reason, Reason::restriction);
}

TEST_F(DualCarriageway, WhatLeadsThereByAnotherEdgeHolds) {
  place.way_restrictions.push_back({1, 4, {inside}});
  place.inner.push_back({8, inside + 1, 0, 1, true, true, -2, 2, {{0, 0}, {3, 10}, {0, 20}}});
  EXPECT_NE(between(junction_movements(place, settings), 0, 3)->reason, Reason::restriction);
}

TEST_F(DualCarriageway, StepsAtSingleNodesLeadTheSameWay) {
  // Lane 100 lies inside.
  place.steps = {
      {11, 1, 100, true, true, true}, {12, 100, 8, true, true, true}, {13, 1, 2, true, true, true}};
  const auto all = junction_movements(place, settings);
  EXPECT_EQ(between(all, 0, 7)->interconnections, (std::vector<std::int64_t>{11, 12}));
  EXPECT_EQ(between(all, 0, 1)->interconnections, (std::vector<std::int64_t>{13}));
  EXPECT_TRUE(between(all, 4, 7)->interconnections.empty());
}

TEST_F(DualCarriageway, OfTooManyPairsNoneIsMade) {
  settings.most = 3;
  EXPECT_TRUE(junction_movements(place, settings).empty());
}

TEST_F(DualCarriageway, AJunctionWithoutLanesHasNoMovement) {
  place.lanes.clear();
  EXPECT_TRUE(junction_movements(place, settings).empty());
}

TEST(Rounded, GivesCornersOfAPieceOneRadius) {
  // Turns by 90 and by 10 degrees, a piece of 10 m between them.
  const Point ahead{std::cos(10 * M_PI / 180), -std::sin(10 * M_PI / 180)};
  const Line guide{{0, 0}, {30, 0}, {30, 10}, Point{30, 10} + Point{ahead.y * -30, ahead.x * 30}};
  const Line path = rounded(guide, 40, 0.01);
  const double tangent = 30 - path[1].x;
  EXPECT_NEAR(tangent, 10 / (1 + std::tan(5 * M_PI / 180)), 1e-9);
}

}  // namespace junction_movement_test
}  // namespace streetgen
