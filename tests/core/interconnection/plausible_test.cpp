// Which interconnections traffic takes.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <tuple>

#include "geometry/polyline.hpp"
#include "interconnection/joined_town.hpp"
#include "rounds.hpp"

namespace streetgen {
namespace plausible_test {

const Line onwards{{0, 0, 0}, {100, 0, 0}};

TEST(Plausible, ALoneLaneTakesEveryWay) {
  const JoinedTown town = crossing(1);
  for (const Interconnection& i : town.join()) EXPECT_TRUE(i.plausible);
}

TEST(Plausible, TheOuterLanesTurnToTheirSide) {
  const JoinedTown town = crossing(3);
  const auto all = town.join();
  EXPECT_EQ(plausible(town, all, 1, 2), (Ranks{{3, 3}}));
  EXPECT_EQ(plausible(town, all, 1, 4), (Ranks{{1, 1}}));
  EXPECT_EQ(plausible(town, all, 1, 3), (Ranks{{1, 1}, {2, 2}, {3, 3}}));
}

TEST(Plausible, ALaneMoreThanGoOnStraightIsForTheTurn) {
  // Three lanes come from the west, two go on to the east, one to the north.
  const JoinedTown town({road(1, west, 3, 0), road(3, {{0, 0, 0}, {100, 0, 0}}, 2, 0),
                         road(4, {{0, 0, 0}, {0, 100, 0}}, 1, 0)});
  const auto all = town.join();
  EXPECT_EQ(plausible(town, all, 1, 4), (Ranks{{1, 1}}));
  EXPECT_EQ(plausible(town, all, 1, 3), (Ranks{{2, 1}, {3, 2}}));
}

TEST(Plausible, AnExitTakesTheLanesOnItsSide) {
  const JoinedTown town({road(1, west, 4, 0), road(3, {{0, 0, 0}, {100, 0, 0}}, 3, 0),
                         road(2, {{0, 0, 0}, {100, -30, 0}}, 1, 0)});
  const auto all = town.join();
  EXPECT_EQ(plausible(town, all, 1, 2), (Ranks{{4, 1}}));
  EXPECT_EQ(plausible(town, all, 1, 3), (Ranks{{1, 1}, {2, 2}, {3, 3}}));
}

TEST(Plausible, AnEntryIsLeftTheLanesOnItsSide) {
  const JoinedTown town({road(1, west, 2, 0), road(2, {{-100, -30, 0}, {0, 0, 0}}, 1, 0),
                         road(3, {{0, 0, 0}, {100, 0, 0}}, 3, 0)});
  const auto all = town.join();
  EXPECT_EQ(plausible(town, all, 1, 3), (Ranks{{1, 1}, {2, 2}}));
  EXPECT_EQ(plausible(town, all, 2, 3), (Ranks{{1, 3}}));
}

// The link bends shortly before it joins, and its last piece comes from the right however its path
// turns.
TEST(Plausible, ALinkFromTheRightEntersOnTheRight) {
  for (const double bend : {20., 40., 60.})
    for (const double aside : {3., 6., 12.}) {
      const JoinedTown town({road(1, west, 2, 0),
                             road(2, {{-100, -aside - 4, 0}, {-bend, -aside, 0}, {0, 0, 0}}, 1, 0),
                             road(3, onwards, 3, 0)});
      const auto all = town.join();
      EXPECT_EQ(plausible(town, all, 1, 3), (Ranks{{1, 1}, {2, 2}})) << bend << ' ' << aside;
      EXPECT_EQ(plausible(town, all, 2, 3), (Ranks{{1, 3}})) << bend << ' ' << aside;
    }
}

// As many lanes go on as come: those of the link merge into the one on its side.
TEST(Plausible, ALinkCrossesNoLaneThatGoesOn) {
  for (const double side : {-1., 1.}) {
    const JoinedTown town({road(1, west, 2, 0), road(2, {{-100, 30 * side, 0}, {0, 0, 0}}, 2, 0),
                           road(3, onwards, 2, 0)});
    const auto all = town.join();
    EXPECT_EQ(plausible(town, all, 1, 3), (Ranks{{1, 1}, {2, 2}}));
    EXPECT_EQ(plausible(town, all, 2, 3),
              side > 0 ? (Ranks{{1, 1}, {2, 1}}) : (Ranks{{1, 2}, {2, 2}}));
  }
}

TEST(Plausible, WhereLanesEndAllLeadOn) {
  const JoinedTown town({road(1, west, 3, 0), road(3, {{0, 0, 0}, {100, 0, 0}}, 2, 0)});
  const Ranks found = plausible(town, town.join(), 1, 3);
  EXPECT_EQ(found.size(), 3u);
  for (int in = 1; in <= 3; ++in) EXPECT_TRUE(found.count({in, 1}) + found.count({in, 2}));
}

TEST(Plausible, WhereLanesBeginAllAreReached) {
  const JoinedTown town({road(1, west, 2, 0), road(3, {{0, 0, 0}, {100, 0, 0}}, 3, 0)});
  const Ranks found = plausible(town, town.join(), 1, 3);
  EXPECT_EQ(found.size(), 3u);
  for (int out = 1; out <= 3; ++out) EXPECT_TRUE(found.count({1, out}) + found.count({2, out}));
}

TEST(Plausible, FollowsWhatIsMarkedOnTheLanes) {
  LanedAxis marked = road(1, west, 3, 0);
  marked.forward[0].turns = turn::left;
  marked.forward[1].turns = turn::left | turn::through;
  marked.forward[2].turns = turn::right;
  const JoinedTown town({marked, road(2, south, 0, 2), road(3, east, 0, 2), road(4, north, 0, 2)});
  const auto all = town.join();
  EXPECT_EQ(plausible(town, all, 1, 4), (Ranks{{1, 1}, {2, 2}}));
  EXPECT_EQ(plausible(town, all, 1, 2).count({3, 2}), 1u);
  EXPECT_EQ(plausible(town, all, 1, 3).count({1, 1}), 0u);
  EXPECT_EQ(reasons(town, all, 1, 4), (std::set<std::string>{"turn_lanes"}));
}

TEST(Plausible, MarksOfAForkGoToItsArmsInOrder) {
  LanedAxis marked = road(1, west, 2, 0);
  marked.forward[0].turns = turn::through;
  marked.forward[1].turns = turn::slight_right;
  // Both arms bend to the left.
  const JoinedTown town(
      {marked, road(3, {{0, 0, 0}, {100, 40, 0}}, 1, 0), road(2, {{0, 0, 0}, {100, 5, 0}}, 1, 0)});
  const auto all = town.join();
  EXPECT_EQ(plausible(town, all, 1, 3), (Ranks{{1, 1}}));
  EXPECT_EQ(plausible(town, all, 1, 2), (Ranks{{2, 1}}));
}

// The left turn lies behind the next node: at the first one a street leaves to the right alone.
TEST(Plausible, AMarkThatNoWayAnswersLeadsStraightOn) {
  LanedAxis marked = road(1, west, 2, 0);
  marked.forward[0].turns = turn::left;
  marked.forward[1].turns = turn::through;
  const JoinedTown town({marked, road(2, south, 0, 1), road(3, east, 0, 2)});
  const auto all = town.join();
  EXPECT_EQ(plausible(town, all, 1, 3), (Ranks{{1, 1}, {2, 2}}));
  EXPECT_EQ(plausible(town, all, 1, 2), (Ranks{{2, 1}}));
}

TEST(Plausible, AnUnmarkedOuterLaneTakesTheTurnsOnItsSide) {
  LanedAxis marked = road(1, west, 2, 1);
  marked.forward[0].turns = turn::left;
  const JoinedTown town({marked, road(2, south, 1, 1), road(3, east, 1, 1), road(4, north, 1, 1)});
  const auto all = town.join();
  EXPECT_EQ(plausible(town, all, 1, 4), (Ranks{{1, 1}}));
  EXPECT_EQ(plausible(town, all, 1, 3), (Ranks{{2, 1}}));
  EXPECT_EQ(plausible(town, all, 1, 2), (Ranks{{2, 1}}));
}

TEST(Plausible, ALaneEndsOnTheSideToWhichItMerges) {
  for (const unsigned mark : {turn::merge_left, turn::merge_right}) {
    LanedAxis marked = road(1, west, 3, 0);
    marked.forward[mark == turn::merge_left ? 2 : 0].turns = mark;
    const JoinedTown town({marked, road(3, onwards, 2, 0)});
    EXPECT_EQ(plausible(town, town.join(), 1, 3), mark == turn::merge_left
                                                      ? (Ranks{{1, 1}, {2, 2}, {3, 2}})
                                                      : (Ranks{{1, 1}, {2, 1}, {3, 2}}));
  }
}

TEST(Plausible, LanesThatLieOnOneLineLeadIntoEachOther) {
  // The axis runs along the left border of the second lane, then of the first.
  LanedAxis three = road(1, west, 3, 0), two = road(3, onwards, 2, 0);
  three.offset = -1.75;
  two.offset = -3.5;
  const JoinedTown town({three, two});
  EXPECT_EQ(plausible(town, town.join(), 1, 3), (Ranks{{1, 1}, {2, 1}, {3, 2}}));
  // The same about a bend.
  two.line = {{0, 0, 0}, {30, 95, 0}};
  const JoinedTown bent({three, two});
  EXPECT_EQ(plausible(bent, bent.join(), 1, 3), (Ranks{{1, 1}, {2, 1}, {3, 2}}));
}

TEST(Plausible, PathsToSpecialLanesCrossNoOthers) {
  LanedAxis special = road(3, onwards, 4, 0);
  special.forward[0].kind = LaneKind::cycle;
  special.forward[3].kind = LaneKind::bus;
  const JoinedTown town({road(1, west, 3, 0), special});
  const Ranks four = plausible(town, town.join(), 1, 3);
  EXPECT_EQ(four.count({1, 1}), 1u);
  EXPECT_EQ(four.count({3, 4}), 1u);
  LanedAxis beside = road(3, onwards, 2, 0);
  beside.forward[1].kind = LaneKind::cycle;
  const JoinedTown merging({road(1, west, 2, 0), beside});
  EXPECT_EQ(plausible(merging, merging.join(), 1, 3), (Ranks{{1, 1}, {2, 1}, {2, 2}}));
}

// Streets of three lanes, the middle one for both directions; ranks count it where it lies along
// the axis alone.
class MiddleLane : public testing::Test {
 protected:
  static LanedAxis street(std::int64_t id, const Line& line) {
    LanedAxis axis = road(id, line, 1, 1);
    axis.both_ways = 1;
    axis.width += 3.5;
    return axis;
  }
  struct Passes {
    std::int64_t from, to;
    bool from_middle, to_middle;
    bool operator<(const Passes& o) const {
      return std::tie(from, to, from_middle, to_middle) <
             std::tie(o.from, o.to, o.from_middle, o.to_middle);
    }
    bool operator==(const Passes& o) const { return !(*this < o) && !(o < *this); }
  };
  static std::set<Passes> passes(const JoinedTown& town,
                                 const InterconnectionSettings& settings = {}) {
    std::set<Passes> found;
    for (const Interconnection& i : town.join({}, settings))
      if (i.plausible)
        found.insert({town.axis_of(i.lane_in), town.axis_of(i.lane_out),
                      town.lane(i.lane_in).middle, town.lane(i.lane_out).middle});
    return found;
  }
};

TEST_F(MiddleLane, IsForLeftTurnsAlone) {
  const JoinedTown town({street(1, west), street(2, onwards), road(3, north, 1, 1)});
  EXPECT_EQ(passes(town), (std::set<Passes>{{1, 2, false, false},
                                            {2, 1, false, false},
                                            {1, 3, true, false},
                                            {2, 3, false, false},
                                            {3, 1, false, false},
                                            {3, 2, false, false}}));
}

TEST_F(MiddleLane, IsForRightTurnsWhereOneDrivesOnTheLeft) {
  InterconnectionSettings settings;
  settings.driving_side = DrivingSide::left;
  const JoinedTown town({street(1, west), street(2, onwards), road(3, south, 1, 1)}, 8,
                        DrivingSide::left);
  EXPECT_EQ(passes(town, settings), (std::set<Passes>{{1, 2, false, false},
                                                      {2, 1, false, false},
                                                      {1, 3, true, false},
                                                      {2, 3, false, false},
                                                      {3, 1, false, false},
                                                      {3, 2, false, false}}));
}

TEST_F(MiddleLane, IsNoWayIntoAStreetWithoutOne) {
  const JoinedTown town({street(1, west), road(2, onwards, 1, 1), road(3, north, 1, 1)});
  EXPECT_EQ(passes(town).count({1, 2, true, false}), 0u);
  EXPECT_EQ(passes(town).count({2, 1, false, true}), 0u);
  EXPECT_EQ(passes(town).count({1, 3, true, false}), 1u);
}

TEST_F(MiddleLane, GoesOnWhereTheStreetAloneDoes) {
  const JoinedTown town({street(1, west), street(2, onwards)});
  EXPECT_EQ(
      passes(town),
      (std::set<Passes>{
          {1, 2, false, false}, {2, 1, false, false}, {1, 2, true, true}, {2, 1, true, true}}));
}

TEST_F(MiddleLane, AMarkedLaneBesideItTurnsOffToo) {
  LanedAxis marked = street(1, west);
  marked.forward[0].turns = turn::left | turn::through;
  const JoinedTown town({marked, street(2, onwards), road(3, north, 1, 1)});
  EXPECT_EQ(passes(town).count({1, 3, true, false}), 1u);
  EXPECT_EQ(passes(town).count({1, 3, false, false}), 1u);
}

TEST(Plausible, ARestrictionForbidsTheTurn) {
  const JoinedTown town = crossing(2);
  const auto all = town.join({{1, 2, {0, 0, 0}, false, {}}});
  EXPECT_TRUE(plausible(town, all, 1, 2).empty());
  EXPECT_EQ(reasons(town, all, 1, 2), (std::set<std::string>{"restriction"}));
  EXPECT_FALSE(plausible(town, all, 2, 1).empty());
  EXPECT_FALSE(plausible(town, all, 1, 3).empty());
}

TEST(Plausible, AnOnlyRestrictionForbidsTheOthers) {
  const JoinedTown town = crossing(2);
  const auto all = town.join({{1, 3, {0, 0, 0}, true, {}}});
  EXPECT_FALSE(plausible(town, all, 1, 3).empty());
  EXPECT_TRUE(plausible(town, all, 1, 2).empty());
  EXPECT_TRUE(plausible(town, all, 1, 4).empty());
}

LaneKinds of(LaneKind kind) { return LaneKinds().set(index_of(kind)); }

TEST(Plausible, ARestrictionDoesNotBindLanesThatItExcepts) {
  std::vector<LanedAxis> roads{road(1, west, 2, 1), road(2, south, 1, 1), road(3, east, 1, 1),
                               road(4, north, 1, 1)};
  roads[0].forward[1].kind = LaneKind::bus;
  const auto only_buses = [&](const TurnRestriction& restriction, std::int64_t to) {
    const JoinedTown town(roads);
    bool buses = false;
    for (const Interconnection& i : town.join({restriction})) {
      if (town.axis_of(i.lane_in) != 1 || town.axis_of(i.lane_out) != to) continue;
      const bool bus = town.lane(i.lane_in).kind == LaneKind::bus;
      EXPECT_EQ(i.reason == Reason::restriction || i.reason == Reason::traffic, !bus);
      // From a lane for all, it is a way for buses alone.
      if (!bus && i.plausible) {
        EXPECT_EQ(i.traffic, of(LaneKind::bus));
      }
      buses = buses || (bus && i.plausible);
    }
    return buses;
  };
  const std::vector<LaneKind> bus{LaneKind::bus};
  EXPECT_TRUE(only_buses({1, 4, {0, 0, 0}, false, {}, bus}, 4));
  EXPECT_TRUE(only_buses({1, 3, {0, 0, 0}, true, {}, bus}, 2));
  // An exception for others is none for buses.
  for (const Interconnection& i :
       JoinedTown(roads).join({{1, 4, {0, 0, 0}, false, {}, {LaneKind::cycle}}}))
    if (i.plausible && JoinedTown(roads).axis_of(i.lane_in) == 1 &&
        JoinedTown(roads).axis_of(i.lane_out) == 4) {
      EXPECT_EQ(i.traffic, of(LaneKind::cycle));
    }
}

TEST(Plausible, WhomARestrictionExceptsHeTurnsFromTheLaneForAll) {
  const JoinedTown town = crossing(1);
  const std::vector<LaneKind> both{LaneKind::bus, LaneKind::cycle};
  const auto turning = [&](const TurnRestriction& restriction, std::int64_t to) {
    std::vector<LaneKinds> found;
    for (const Interconnection& i : town.join({restriction}))
      if (i.plausible && town.axis_of(i.lane_in) == 1 && town.axis_of(i.lane_out) == to)
        found.push_back(i.traffic);
    return found;
  };
  const LaneKinds all = of(LaneKind::general), some = of(LaneKind::bus) | of(LaneKind::cycle);
  EXPECT_EQ(turning({1, 4, {0, 0, 0}, false, {}, both}, 4), std::vector<LaneKinds>{some});
  EXPECT_EQ(turning({1, 4, {0, 0, 0}, false, {}, both}, 3), std::vector<LaneKinds>{all});
  EXPECT_EQ(turning({1, 3, {0, 0, 0}, true, {}, both}, 2), std::vector<LaneKinds>{some});
}

TEST(Plausible, BusesComeUponTheirStreetFromEveryArm) {
  std::vector<LanedAxis> roads{road(1, west, 1, 1), road(2, south, 1, 1), road(3, east, 1, 1),
                               road(4, north, 1, 1)};
  roads[3].forward[0].kind = roads[3].backward[0].kind = LaneKind::bus;
  const JoinedTown town(roads);
  std::map<std::int64_t, LaneKinds> into, out;
  for (const Interconnection& i : town.join()) {
    if (!i.plausible) continue;
    if (town.axis_of(i.lane_out) == 4) into[town.axis_of(i.lane_in)] |= i.traffic;
    if (town.axis_of(i.lane_in) == 4) out[town.axis_of(i.lane_out)] |= i.traffic;
    if (town.axis_of(i.lane_in) != 4 && town.axis_of(i.lane_out) != 4) {
      EXPECT_EQ(i.traffic, of(LaneKind::general));
    }
  }
  const std::map<std::int64_t, LaneKinds> every{
      {1, of(LaneKind::bus)}, {2, of(LaneKind::bus)}, {3, of(LaneKind::bus)}};
  EXPECT_EQ(into, every);
  EXPECT_EQ(out, every);
}

TEST(Plausible, CarpoolLanesLeadAsGeneralLanesDo) {
  const auto ways = [](LaneKind kind) {
    std::vector<LanedAxis> roads{road(1, west, 3, 1), road(2, south, 1, 1), road(3, east, 2, 3),
                                 road(4, north, 1, 1)};
    roads[0].forward[0].kind = kind;
    const JoinedTown town(roads);
    std::vector<std::tuple<int, int, bool>> found;
    for (const Interconnection& i : town.join())
      found.emplace_back(i.lane_in, i.lane_out, i.plausible);
    return found;
  };
  EXPECT_EQ(ways(LaneKind::carpool), ways(LaneKind::general));
}

TEST(Plausible, NobodyDrivesOnAClosedLane) {
  LanedAxis closed = road(1, west, 2, 0);
  closed.forward[1].kind = LaneKind::closed;
  EXPECT_EQ(JoinedTown({closed, road(3, {{0, 0, 0}, {100, 0, 0}}, 1, 0)}).join().size(), 1u);
}

TEST(Plausible, ARestrictionLetsIntoTheLanesThatItExcepts) {
  std::vector<LanedAxis> roads{road(1, west, 1, 1), road(2, south, 1, 1), road(4, north, 1, 2)};
  roads[2].backward[1].kind = LaneKind::bus;
  const JoinedTown town(roads);
  std::set<LaneKind> reached;
  LaneKinds traffic;
  for (const Interconnection& i : town.join({{1, 4, {0, 0, 0}, false, {}, {LaneKind::bus}},
                                             {2, 4, {0, 0, 0}, false, {}, {LaneKind::bus}}}))
    if (i.plausible && town.axis_of(i.lane_out) == 4) {
      reached.insert(town.lane(i.lane_out).kind);
      traffic |= i.traffic;
    }
  EXPECT_EQ(reached.count(LaneKind::bus), 1u);
  EXPECT_EQ(traffic, of(LaneKind::bus));
}

TEST(Plausible, OfContradictoryRestrictionsTheForbiddingOneHolds) {
  const JoinedTown town = crossing(1);
  const auto all = town.join({{1, 3, {0, 0, 0}, true, {}}, {1, 3, {0, 0, 0}, false, {}}});
  for (const std::int64_t to : {2, 3, 4}) EXPECT_TRUE(plausible(town, all, 1, to).empty());
}

TEST(Plausible, ARestrictionElsewhereChangesNothing) {
  const JoinedTown town = crossing(1);
  for (const TurnRestriction& r : {TurnRestriction{1, 2, {50, 50, 0}, false, {}},
                                   TurnRestriction{1, 99, {0, 0, 0}, false, {}}})
    for (const Interconnection& i : town.join({r})) EXPECT_TRUE(i.plausible);
}

// One axis from west to east, one from south to north, which meet at a shared vertex.
TEST(Plausible, TheTurnTellsTheEdgesOfAnAxisThatGoesOnApart) {
  const JoinedTown town({road(1, {{-100, 0, 0}, {0, 0, 0}, {100, 0, 0}}, 1, 1),
                         road(2, {{0, -100, 0}, {0, 0, 0}, {0, 100, 0}}, 1, 1)});
  for (const Interconnection& i : town.join({{1, 2, {0, 0, 0}, false, Turn::left}}))
    EXPECT_EQ(i.plausible, !(town.axis_of(i.lane_in) == 1 && town.axis_of(i.lane_out) == 2 &&
                             i.turn == Turn::left));
}

TEST(Plausible, BusesStayOnBusLanesAndCarsOff) {
  LanedAxis from = road(1, west, 2, 0), to = road(3, {{0, 0, 0}, {100, 0, 0}}, 2, 0);
  from.forward[1].kind = to.forward[1].kind = LaneKind::bus;
  const JoinedTown town({from, to});
  const auto all = town.join();
  EXPECT_EQ(plausible(town, all, 1, 3), (Ranks{{1, 1}, {2, 2}}));
  EXPECT_EQ(reasons(town, all, 1, 3), (std::set<std::string>{"lane_kind", "lane_order"}));
}

TEST(Plausible, ABusLaneBeginsAndEndsAmongGeneralLanes) {
  LanedAxis with = road(1, west, 2, 0), without = road(3, {{0, 0, 0}, {100, 0, 0}}, 1, 0);
  with.forward[1].kind = LaneKind::bus;
  const JoinedTown ends({with, without});
  EXPECT_EQ(plausible(ends, ends.join(), 1, 3), (Ranks{{1, 1}, {2, 1}}));
  with.line = reversed(with.line);
  without.line = reversed(without.line);
  const JoinedTown begins({with, without});
  EXPECT_EQ(plausible(begins, begins.join(), 3, 1), (Ranks{{1, 1}, {1, 2}}));
}

TEST(Plausible, ParkingLanesTakeNoPart) {
  LanedAxis parked = road(1, west, 2, 0);
  parked.forward[1].kind = LaneKind::parking;
  EXPECT_EQ(JoinedTown({parked, road(3, {{0, 0, 0}, {100, 0, 0}}, 1, 0)}).join().size(), 1u);
}

// A street parts into two carriageways.
TEST(Plausible, NothingTurnsBackWhereItCanGoOn) {
  const JoinedTown town({road(1, west, 1, 1), road(2, {{0, 0, 0}, {100, -8, 0}}, 1, 0),
                         road(3, {{100, 8, 0}, {0, 0, 0}}, 1, 0)});
  const auto all = town.join();
  EXPECT_EQ(plausible(town, all, 1, 2), (Ranks{{1, 1}}));
  EXPECT_EQ(plausible(town, all, 3, 1), (Ranks{{1, 1}}));
  EXPECT_EQ(reasons(town, all, 3, 2), (std::set<std::string>{"u_turn"}));
}

// On a small ring one leaves or enters by turns as sharp.
TEST(Plausible, OntoARoundaboutNobodyTurnsBack) {
  const JoinedTown town({road(1, west, 1, 1), road(2, {{0, 0, 0}, {100, -8, 0}}, 1, 0),
                         road(3, {{100, 8, 0}, {0, 0, 0}}, 1, 0)});
  const auto all = town.join({}, {}, {{2, 50, true, false}});
  // Where the ground lets a car do so.
  EXPECT_EQ(reasons(town, all, 3, 2).count("u_turn"), 0u);
  EXPECT_EQ(plausible(town, all, 3, 1), (Ranks{{1, 1}}));
}

TEST(Plausible, AMarkedLaneTurnsBack) {
  LanedAxis marked = road(3, {{100, 8, 0}, {0, 0, 0}}, 2, 0);
  marked.forward[0].turns = turn::reverse;
  marked.forward[1].turns = turn::through;
  const JoinedTown town({road(1, west, 1, 2), road(2, {{0, 0, 0}, {100, -8, 0}}, 1, 0), marked});
  EXPECT_EQ(plausible(town, town.join(), 3, 2), (Ranks{{1, 1}}));
}

TEST(Plausible, ADeadEndTurnsBackBesideTheOtherDirection) {
  InterconnectionSettings settings;
  settings.u_turn = true;
  const JoinedTown town({road(1, west, 2, 2)});
  EXPECT_EQ(plausible(town, town.join({}, settings), 1, 1).count({1, 1}), 1u);
}

// Into the lane at the kerb where it can, else into the next.
TEST(Plausible, ATightTurnTakesTheNextLane) {
  for (const double radius : {1., 2., 4., 8., 12.}) {
    const JoinedTown town = crossing(3, radius);
    double at_kerb = 0, next = 0;
    Ranks found;
    for (const Interconnection& i : town.join()) {
      if (town.axis_of(i.lane_in) != 1 || town.axis_of(i.lane_out) != 2) continue;
      if (town.rank(i.lane_in) == 3 && town.rank(i.lane_out) == 3) at_kerb = quarter_radius(i.line);
      if (town.rank(i.lane_in) == 3 && town.rank(i.lane_out) == 2) next = quarter_radius(i.line);
      if (i.plausible) found.insert({town.rank(i.lane_in), town.rank(i.lane_out)});
    }
    EXPECT_EQ(found.count({3, 3}), at_kerb >= 3 ? 1u : 0u) << radius;
    EXPECT_EQ(found.count({3, 2}), at_kerb < 3 && next >= 3 ? 1u : 0u) << radius;
  }
}

// At 110 km/h both turns are tight, that of the bus lane at the kerb too.
TEST(Plausible, ATightTurnIsLeftToNoBusLaneAlone) {
  for (const double radius : {0.5, 1., 2.}) {
    LanedAxis special = road(1, west, 2, 1);
    special.forward[1].kind = LaneKind::bus;
    std::vector<LanedAxis> roads{special, road(2, south, 1, 1), road(3, east, 2, 2)};
    for (LanedAxis& r : roads) r.speed = 110;
    const JoinedTown town(roads, radius);
    EXPECT_EQ(plausible(town, town.join(), 1, 2).count({1, 1}), 1u) << radius;
  }
}

// Of two lanes that turn sharply one has no path to its lane that a car can drive; the cycle lane
// beyond it is no way on.
TEST(Plausible, TheOnlyWayOnIsOneForCars) {
  for (const double apart : {40., 46., 52., 58., 64.})
    for (const double reach : {5., 6.5, 8., 10., 14.}) {
      const double angle = -apart * M_PI / 180;
      LanedAxis comes = road(1, {{-8, 0, 0}, {0, 0, 0}}, 3, 0),
                goes = road(3, {{0, 0, 0}, {reach, 0, 0}}, 3, 0);
      comes.forward[0].kind = goes.forward[0].kind = LaneKind::cycle;
      comes.width = goes.width = 8.5;
      LanedAxis turns =
          road(2, {{100 * std::cos(angle), 100 * std::sin(angle), 0}, {0, 0, 0}}, 2, 0);
      turns.width = 6;
      const JoinedTown town({comes, goes, turns, road(4, {{reach, 0, 0}, {reach + 90, 0, 0}}, 2, 0),
                             road(5, {{reach, 0, 0}, {reach, -90, 0}}, 1, 1)},
                            4);
      const Ranks found = plausible(town, town.join(), 2, 3);
      for (const int lane : {1, 2})
        EXPECT_GE(found.count({lane, 2}) + found.count({lane, 3}), 1u)
            << apart << " degrees, " << reach << " m, lane " << lane;
    }
}

// At 110 km/h a turn needs 7 m, and the one about the nose between 2 and 3 has less on either lane:
// the lane of 2 that it alone took is left to 1.
TEST(Plausible, ATightTurnGivesWayToAWideOne) {
  std::vector<LanedAxis> roads{road(1, west, 1, 1), road(2, {{0, 0, 0}, {100, 20, 0}}, 2, 0),
                               road(3, {{40, -92, 0}, {0, 0, 0}}, 1, 0)};
  for (LanedAxis& r : roads) r.speed = 110;
  const JoinedTown town(roads, 0.5);
  const auto all = town.join();
  for (const Interconnection& i : all)
    if (town.axis_of(i.lane_in) == 3 && town.axis_of(i.lane_out) == 2) {
      ASSERT_LT(quarter_radius(i.line), 7);
    }
  EXPECT_EQ(plausible(town, all, 1, 2), (Ranks{{1, 1}, {1, 2}}));
  EXPECT_EQ(reasons(town, all, 3, 2), (std::set<std::string>{"radius", "lane_order"}));
  EXPECT_EQ(plausible(town, all, 3, 2), Ranks{});
  EXPECT_EQ(plausible(town, all, 3, 1), (Ranks{{1, 1}}));
}

// Marked to go straight on, it may go on to each lane there; the turn from the south keeps to its
// kerb.
TEST(Plausible, AMarkedLaneTakesTheLanesThatNoneReaches) {
  const JoinedTown town({{1, west, general(1, turn::through), {}, 3.5, 50},
                         road(2, south, 1, 0),
                         road(3, {{0, 0, 0}, {100, 0, 0}}, 3, 0)});
  const auto all = town.join();
  EXPECT_EQ(plausible(town, all, 1, 3), (Ranks{{1, 1}, {1, 2}}));
  EXPECT_EQ(plausible(town, all, 2, 3), (Ranks{{1, 3}}));
}

TEST(Plausible, EveryLaneLeadsOnAndIsReachedWhereAnotherStreetAllows) {
  for (int seed = 1; seed <= rounds(400); ++seed) {
    const JoinedTown town(LanedStar(seed).roads());
    std::map<int, bool> spreads, reached;
    for (const Interconnection& i : town.join()) {
      spreads[i.lane_in] = spreads[i.lane_in] || i.plausible;
      reached[i.lane_out] = reached[i.lane_out] || i.plausible;
    }
    for (const auto& [lane, holds] : spreads) EXPECT_TRUE(holds) << seed << " in " << lane;
    for (const auto& [lane, holds] : reached) EXPECT_TRUE(holds) << seed << " out " << lane;
  }
}

// By lane order, of two lanes of one approach the left one never goes on to the right of the other.
TEST(Plausible, LanesOfOneApproachDoNotCross) {
  for (int seed = 1; seed <= rounds(400); ++seed) {
    const JoinedTown town(LanedStar(seed).roads());
    const auto all = town.join();
    for (const Interconnection& a : all)
      for (const Interconnection& b : all) {
        if (!a.plausible || !b.plausible || a.reason != Reason::lane_order ||
            b.reason != Reason::lane_order)
          continue;
        if (town.lane(a.lane_in).edge != town.lane(b.lane_in).edge ||
            town.lane(a.lane_out).edge != town.lane(b.lane_out).edge)
          continue;
        EXPECT_LE((town.rank(a.lane_in) - town.rank(b.lane_in)) *
                      (town.rank(b.lane_out) - town.rank(a.lane_out)),
                  0)
            << seed;
      }
  }
}

TEST(Plausible, DoesNotDependOnTheOrderOfTheAxes) {
  for (unsigned seed = 1; seed <= 100; ++seed) {
    std::vector<LanedAxis> roads = LanedStar(seed).roads();
    const JoinedTown town(roads);
    std::reverse(roads.begin(), roads.end());
    const JoinedTown other(roads);
    const auto a = town.join(), b = other.join();
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].lane_in, b[i].lane_in);
      EXPECT_EQ(a[i].lane_out, b[i].lane_out);
      EXPECT_EQ(a[i].plausible, b[i].plausible) << seed;
      EXPECT_EQ(a[i].reason, b[i].reason) << seed;
    }
  }
}

}  // namespace plausible_test
}  // namespace streetgen
