#include "streetgen/interconnection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <tuple>

#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {
namespace {

// An axis with its lanes, each list from left to right in its driving direction.
struct Road {
  std::int64_t id = 0;
  Line line;
  std::vector<LaneWish> forward, backward;
  double width = 0;
  double speed = 50;
  int both_ways = 0;  // lanes
};

std::vector<LaneWish> general(int count, unsigned turns = 0) {
  LaneWish lane;
  lane.turns = turns;
  return std::vector<LaneWish>(count, lane);
}

Road road(std::int64_t id, const Line& line, int forward, int backward) {
  return {id, line, general(forward), general(backward), 3.5 * (forward + backward), 50};
}

// One lane that both directions use.
Road narrow(std::int64_t id, const Line& line) { return {id, line, {}, {}, 3.5, 50, 1}; }

class Town {
 public:
  explicit Town(const std::vector<Road>& roads, double radius = 8) {
    std::vector<LanesOfAxis> wishes;
    for (const Road& r : roads) {
      axes_.push_back({r.id, r.line, 0, r.width, r.width, radius, 5, r.speed});
      wishes.push_back({r.id, {r.forward, r.backward, general(r.both_ways)}});
    }
    streets_ = streets(axes_, {});
    lanes_ = streetgen::lanes(streets_, wishes, {}, {}).lanes;
  }

  std::vector<Interconnection> join(const std::vector<TurnRestriction>& restrictions = {},
                                    const InterconnectionSettings& settings = {}) const {
    return interconnections(streets_, axes_, lanes_, restrictions, settings);
  }

  const Lane& lane(int index) const { return lanes_[index]; }
  // Whether the point lies on the roadway.
  bool holds(const Point& p) const {
    const auto on = [&](const MultiPolygon& surface) {
      return std::any_of(surface.begin(), surface.end(),
                         [&](const Polygon& polygon) { return inside(p, polygon); });
    };
    return std::any_of(streets_.sections.begin(), streets_.sections.end(),
                       [&](const Section& section) { return on(section.surface); }) ||
           std::any_of(streets_.intersections.begin(), streets_.intersections.end(),
                       [&](const Intersection& i) { return on(i.surface); });
  }
  std::int64_t axis_of(int lane) const { return streets_.network.edges[lanes_[lane].edge].axis_id; }
  // From 1, from left to right in the driving direction.
  int rank(int index) const {
    int rank = 1;
    for (const Lane& other : lanes_)
      if (other.edge == lanes_[index].edge && other.along_axis == lanes_[index].along_axis &&
          (lanes_[index].along_axis ? other.position < lanes_[index].position
                                    : other.position > lanes_[index].position))
        ++rank;
    return rank;
  }

 private:
  std::vector<StreetAxis> axes_;
  Streets streets_;
  std::vector<Lane> lanes_;
};

// What goes on plausibly from axis to axis, as pairs of ranks.
using Ranks = std::set<std::pair<int, int>>;
Ranks plausible(const Town& town, const std::vector<Interconnection>& all, std::int64_t from,
                std::int64_t to) {
  Ranks found;
  for (const Interconnection& i : all)
    if (i.plausible && town.axis_of(i.lane_in) == from && town.axis_of(i.lane_out) == to)
      found.insert({town.rank(i.lane_in), town.rank(i.lane_out)});
  return found;
}

std::set<std::string> reasons(const Town& town, const std::vector<Interconnection>& all,
                              std::int64_t from, std::int64_t to) {
  std::set<std::string> found;
  for (const Interconnection& i : all)
    if (town.axis_of(i.lane_in) == from && town.axis_of(i.lane_out) == to)
      found.insert(reason_name(i.reason));
  return found;
}

// West, south, east, north of (0, 0): all drawn towards it.
const Line west{{-100, 0, 0}, {0, 0, 0}}, south{{0, -100, 0}, {0, 0, 0}},
    east{{100, 0, 0}, {0, 0, 0}}, north{{0, 100, 0}, {0, 0, 0}};

Town crossing(int lanes, double radius = 8) {
  return Town({road(1, west, lanes, lanes), road(2, south, lanes, lanes),
               road(3, east, lanes, lanes), road(4, north, lanes, lanes)},
              radius);
}

TEST(Interconnection, PairsEveryLaneInWithEveryLaneOutOfAnotherEdge) {
  EXPECT_EQ(crossing(1).join().size(), 12u);
  EXPECT_EQ(crossing(2).join().size(), 48u);
}

TEST(Interconnection, UTurnPairsAlsoLanesOfOneEdge) {
  InterconnectionSettings settings;
  settings.u_turn = true;
  const Town town = crossing(1);
  const auto all = town.join({}, settings);
  // Four at the crossing, one at each of the four dead ends.
  EXPECT_EQ(all.size(), 12u + 4u + 4u);
  for (const Interconnection& i : all)
    if (town.lane(i.lane_in).edge == town.lane(i.lane_out).edge) {
      EXPECT_EQ(i.turn, Turn::u_turn);
    }
}

TEST(Interconnection, HasTheKindAndTheAngleOfItsTurn) {
  const Town town = crossing(1);
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
  const Town town = crossing(2);
  for (const Interconnection& i : town.join()) {
    const Lane &in = town.lane(i.lane_in), &out = town.lane(i.lane_out);
    EXPECT_EQ(distance(i.line.front(), in.along_axis ? in.line.back() : in.line.front()), 0);
    EXPECT_EQ(distance(i.line.back(), out.along_axis ? out.line.front() : out.line.back()), 0);
  }
}

// As (from, to, along the axis of the one, of the other).
using Ways = std::set<std::tuple<std::int64_t, std::int64_t, bool, bool>>;
Ways ways(const Town& town, const std::vector<Interconnection>& all) {
  Ways found;
  for (const Interconnection& i : all)
    found.emplace(town.axis_of(i.lane_in), town.axis_of(i.lane_out), i.along_in, i.along_out);
  EXPECT_EQ(found.size(), all.size());
  return found;
}

TEST(Interconnection, ALaneForBothDirectionsComesInAndGoesOutAtBothEnds) {
  const Line middle{{0, 0, 0}, {90, 0, 0}}, onwards{{180, 0, 0}, {90, 0, 0}};
  const Town town({narrow(1, west), narrow(2, middle), road(3, onwards, 1, 1)});
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
    const Town town({narrow(1, west), narrow(2, away), narrow(3, east), narrow(4, north)});
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
  const Town ring({narrow(1, upper), narrow(2, lower)});
  EXPECT_EQ(
      ways(ring, ring.join()),
      (Ways{{1, 2, true, false}, {2, 1, true, false}, {1, 2, false, true}, {2, 1, false, true}}));
  const Line loop{{0, 0, 0}, {60, -60, 0}, {120, 0, 0}, {60, 60, 0}, {0, 0, 0}};
  const Town lasso({narrow(1, west), narrow(2, loop)});
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
      std::vector<Road> roads;
      double angle = 0;
      for (const double step : {0., narrow, wide, narrow}) {
        angle += step * M_PI / 180;
        roads.push_back(road(static_cast<std::int64_t>(roads.size()) + 1,
                             {{0, 0, 0}, {300 * std::cos(angle), 300 * std::sin(angle), 0}}, 1, 1));
      }
      const Town town(roads);
      for (const Interconnection& i : town.join())
        for (double at = 0.05; at < length(i.line); at += 0.1)
          EXPECT_TRUE(town.holds(position_at(i.line, at).point))
              << narrow << ' ' << wide << ' ' << at;
    }
}

// Random stars of streets, some of them one-way.
class Star {
 public:
  explicit Star(unsigned seed) : random_(seed) {}
  std::vector<Road> roads() {
    std::vector<Road> out;
    const int count = 3 + pick(3);
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * M_PI * (i + 0.6 * pick(100) / 100) / count;
      const Line line{{0, 0, 0}, {150 * std::cos(angle), 150 * std::sin(angle), 0}};
      int forward = pick(4), backward = pick(4);
      if (i == 0) forward = 1 + pick(3);
      if (i == 1) backward = 1 + pick(3);
      if (forward + backward == 0) forward = 1;
      out.push_back(road(i + 1, line, forward, backward));
    }
    return out;
  }

 private:
  int pick(int n) { return static_cast<int>(random_() % n); }
  std::mt19937 random_;
};

// Tangents of a right turn about a kerb arc of 8 m are 8 + 3.5 / 2 m long; the parabola between
// them bends by no less than that length / sqrt(2) = 6.9 m.
TEST(Interconnection, ATurnIsAsWideAsTheKerbsAllow) {
  const Town town = crossing(1);
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

TEST(Interconnection, APathThatTrafficTakesHasNoCorner) {
  int taken = 0, kept = 0, out = 0;
  for (unsigned seed = 1; seed <= 400; ++seed) {
    const Town town(Star(seed).roads());
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
  EXPECT_GT(taken, 1000);
  EXPECT_LT(kept + out, taken / 100);
}

TEST(Plausible, ALoneLaneTakesEveryWay) {
  const Town town = crossing(1);
  for (const Interconnection& i : town.join()) EXPECT_TRUE(i.plausible);
}

TEST(Plausible, TheOuterLanesTurnToTheirSide) {
  const Town town = crossing(3);
  const auto all = town.join();
  EXPECT_EQ(plausible(town, all, 1, 2), (Ranks{{3, 3}}));
  EXPECT_EQ(plausible(town, all, 1, 4), (Ranks{{1, 1}}));
  EXPECT_EQ(plausible(town, all, 1, 3), (Ranks{{1, 1}, {2, 2}, {3, 3}}));
}

TEST(Plausible, ALaneMoreThanGoOnStraightIsForTheTurn) {
  // Three lanes come from the west, two go on to the east, one to the north.
  const Town town({road(1, west, 3, 0), road(3, {{0, 0, 0}, {100, 0, 0}}, 2, 0),
                   road(4, {{0, 0, 0}, {0, 100, 0}}, 1, 0)});
  const auto all = town.join();
  EXPECT_EQ(plausible(town, all, 1, 4), (Ranks{{1, 1}}));
  EXPECT_EQ(plausible(town, all, 1, 3), (Ranks{{2, 1}, {3, 2}}));
}

TEST(Plausible, AnExitTakesTheLanesOnItsSide) {
  const Town town({road(1, west, 4, 0), road(3, {{0, 0, 0}, {100, 0, 0}}, 3, 0),
                   road(2, {{0, 0, 0}, {100, -30, 0}}, 1, 0)});
  const auto all = town.join();
  EXPECT_EQ(plausible(town, all, 1, 2), (Ranks{{4, 1}}));
  EXPECT_EQ(plausible(town, all, 1, 3), (Ranks{{1, 1}, {2, 2}, {3, 3}}));
}

TEST(Plausible, AnEntryIsLeftTheLanesOnItsSide) {
  const Town town({road(1, west, 2, 0), road(2, {{-100, -30, 0}, {0, 0, 0}}, 1, 0),
                   road(3, {{0, 0, 0}, {100, 0, 0}}, 3, 0)});
  const auto all = town.join();
  EXPECT_EQ(plausible(town, all, 1, 3), (Ranks{{1, 1}, {2, 2}}));
  EXPECT_EQ(plausible(town, all, 2, 3), (Ranks{{1, 3}}));
}

TEST(Plausible, WhereLanesEndAllLeadOn) {
  const Town town({road(1, west, 3, 0), road(3, {{0, 0, 0}, {100, 0, 0}}, 2, 0)});
  const Ranks found = plausible(town, town.join(), 1, 3);
  EXPECT_EQ(found.size(), 3u);
  for (int in = 1; in <= 3; ++in) EXPECT_TRUE(found.count({in, 1}) + found.count({in, 2}));
}

TEST(Plausible, WhereLanesBeginAllAreReached) {
  const Town town({road(1, west, 2, 0), road(3, {{0, 0, 0}, {100, 0, 0}}, 3, 0)});
  const Ranks found = plausible(town, town.join(), 1, 3);
  EXPECT_EQ(found.size(), 3u);
  for (int out = 1; out <= 3; ++out) EXPECT_TRUE(found.count({1, out}) + found.count({2, out}));
}

TEST(Plausible, FollowsWhatIsMarkedOnTheLanes) {
  Road marked = road(1, west, 3, 0);
  marked.forward[0].turns = turn::left;
  marked.forward[1].turns = turn::left | turn::through;
  marked.forward[2].turns = turn::right;
  const Town town({marked, road(2, south, 0, 2), road(3, east, 0, 2), road(4, north, 0, 2)});
  const auto all = town.join();
  EXPECT_EQ(plausible(town, all, 1, 4), (Ranks{{1, 1}, {2, 2}}));
  EXPECT_EQ(plausible(town, all, 1, 2).count({3, 2}), 1u);
  EXPECT_EQ(plausible(town, all, 1, 3).count({1, 1}), 0u);
  EXPECT_EQ(reasons(town, all, 1, 4), (std::set<std::string>{"turn_lanes"}));
}

TEST(Plausible, MarksOfAForkGoToItsArmsInOrder) {
  Road marked = road(1, west, 2, 0);
  marked.forward[0].turns = turn::through;
  marked.forward[1].turns = turn::slight_right;
  // Both arms bend to the left.
  const Town town(
      {marked, road(3, {{0, 0, 0}, {100, 40, 0}}, 1, 0), road(2, {{0, 0, 0}, {100, 5, 0}}, 1, 0)});
  const auto all = town.join();
  EXPECT_EQ(plausible(town, all, 1, 3), (Ranks{{1, 1}}));
  EXPECT_EQ(plausible(town, all, 1, 2), (Ranks{{2, 1}}));
}

TEST(Plausible, ARestrictionForbidsTheTurn) {
  const Town town = crossing(2);
  const auto all = town.join({{1, 2, {0, 0, 0}, false, {}}});
  EXPECT_TRUE(plausible(town, all, 1, 2).empty());
  EXPECT_EQ(reasons(town, all, 1, 2), (std::set<std::string>{"restriction"}));
  EXPECT_FALSE(plausible(town, all, 2, 1).empty());
  EXPECT_FALSE(plausible(town, all, 1, 3).empty());
}

TEST(Plausible, AnOnlyRestrictionForbidsTheOthers) {
  const Town town = crossing(2);
  const auto all = town.join({{1, 3, {0, 0, 0}, true, {}}});
  EXPECT_FALSE(plausible(town, all, 1, 3).empty());
  EXPECT_TRUE(plausible(town, all, 1, 2).empty());
  EXPECT_TRUE(plausible(town, all, 1, 4).empty());
}

TEST(Plausible, ARestrictionDoesNotBindLanesThatItExcepts) {
  std::vector<Road> roads{road(1, west, 2, 1), road(2, south, 1, 1), road(3, east, 1, 1),
                          road(4, north, 1, 1)};
  roads[0].forward[1].kind = LaneKind::bus;
  const auto only_buses = [&](const TurnRestriction& restriction, std::int64_t to) {
    const Town town(roads);
    bool buses = false;
    for (const Interconnection& i : town.join({restriction})) {
      if (town.axis_of(i.lane_in) != 1 || town.axis_of(i.lane_out) != to) continue;
      const bool bus = town.lane(i.lane_in).kind == LaneKind::bus;
      EXPECT_EQ(i.reason == Reason::restriction, !bus);
      buses = buses || (bus && i.plausible);
    }
    return buses;
  };
  const std::vector<LaneKind> bus{LaneKind::bus};
  EXPECT_TRUE(only_buses({1, 4, {0, 0, 0}, false, {}, bus}, 4));
  EXPECT_TRUE(only_buses({1, 3, {0, 0, 0}, true, {}, bus}, 2));
  // An exception for others is none for buses.
  for (const Interconnection& i :
       Town(roads).join({{1, 4, {0, 0, 0}, false, {}, {LaneKind::cycle}}}))
    EXPECT_FALSE(i.plausible && Town(roads).axis_of(i.lane_in) == 1 &&
                 Town(roads).axis_of(i.lane_out) == 4);
}

TEST(Plausible, ARestrictionLetsIntoTheLanesThatItExcepts) {
  std::vector<Road> roads{road(1, west, 1, 1), road(2, south, 1, 1), road(4, north, 1, 2)};
  roads[2].backward[1].kind = LaneKind::bus;
  const Town town(roads);
  std::set<LaneKind> reached;
  for (const Interconnection& i : town.join({{1, 4, {0, 0, 0}, false, {}, {LaneKind::bus}},
                                             {2, 4, {0, 0, 0}, false, {}, {LaneKind::bus}}}))
    if (i.plausible && town.axis_of(i.lane_out) == 4) reached.insert(town.lane(i.lane_out).kind);
  EXPECT_EQ(reached, (std::set<LaneKind>{LaneKind::bus}));
}

TEST(Plausible, OfContradictoryRestrictionsTheForbiddingOneHolds) {
  const Town town = crossing(1);
  const auto all = town.join({{1, 3, {0, 0, 0}, true, {}}, {1, 3, {0, 0, 0}, false, {}}});
  for (const std::int64_t to : {2, 3, 4}) EXPECT_TRUE(plausible(town, all, 1, to).empty());
}

TEST(Plausible, ARestrictionElsewhereChangesNothing) {
  const Town town = crossing(1);
  for (const TurnRestriction& r : {TurnRestriction{1, 2, {50, 50, 0}, false, {}},
                                   TurnRestriction{1, 99, {0, 0, 0}, false, {}}})
    for (const Interconnection& i : town.join({r})) EXPECT_TRUE(i.plausible);
}

// One axis from west to east, one from south to north, which meet at a shared vertex.
TEST(Plausible, TheTurnTellsTheEdgesOfAnAxisThatGoesOnApart) {
  const Town town({road(1, {{-100, 0, 0}, {0, 0, 0}, {100, 0, 0}}, 1, 1),
                   road(2, {{0, -100, 0}, {0, 0, 0}, {0, 100, 0}}, 1, 1)});
  for (const Interconnection& i : town.join({{1, 2, {0, 0, 0}, false, Turn::left}}))
    EXPECT_EQ(i.plausible, !(town.axis_of(i.lane_in) == 1 && town.axis_of(i.lane_out) == 2 &&
                             i.turn == Turn::left));
}

TEST(Plausible, BusesStayOnBusLanesAndCarsOff) {
  Road from = road(1, west, 2, 0), to = road(3, {{0, 0, 0}, {100, 0, 0}}, 2, 0);
  from.forward[1].kind = to.forward[1].kind = LaneKind::bus;
  const Town town({from, to});
  const auto all = town.join();
  EXPECT_EQ(plausible(town, all, 1, 3), (Ranks{{1, 1}, {2, 2}}));
  EXPECT_EQ(reasons(town, all, 1, 3), (std::set<std::string>{"lane_kind", "lane_order"}));
}

TEST(Plausible, ABusLaneBeginsAndEndsAmongGeneralLanes) {
  Road with = road(1, west, 2, 0), without = road(3, {{0, 0, 0}, {100, 0, 0}}, 1, 0);
  with.forward[1].kind = LaneKind::bus;
  const Town ends({with, without});
  EXPECT_EQ(plausible(ends, ends.join(), 1, 3), (Ranks{{1, 1}, {2, 1}}));
  with.line = reversed(with.line);
  without.line = reversed(without.line);
  const Town begins({with, without});
  EXPECT_EQ(plausible(begins, begins.join(), 3, 1), (Ranks{{1, 1}, {1, 2}}));
}

TEST(Plausible, ParkingLanesTakeNoPart) {
  Road parked = road(1, west, 2, 0);
  parked.forward[1].kind = LaneKind::parking;
  EXPECT_EQ(Town({parked, road(3, {{0, 0, 0}, {100, 0, 0}}, 1, 0)}).join().size(), 1u);
}

// A street parts into two carriageways.
TEST(Plausible, NothingTurnsBackWhereItCanGoOn) {
  const Town town({road(1, west, 1, 1), road(2, {{0, 0, 0}, {100, -8, 0}}, 1, 0),
                   road(3, {{100, 8, 0}, {0, 0, 0}}, 1, 0)});
  const auto all = town.join();
  EXPECT_EQ(plausible(town, all, 1, 2), (Ranks{{1, 1}}));
  EXPECT_EQ(plausible(town, all, 3, 1), (Ranks{{1, 1}}));
  EXPECT_EQ(reasons(town, all, 3, 2), (std::set<std::string>{"u_turn"}));
}

TEST(Plausible, AMarkedLaneTurnsBack) {
  Road marked = road(3, {{100, 8, 0}, {0, 0, 0}}, 2, 0);
  marked.forward[0].turns = turn::reverse;
  marked.forward[1].turns = turn::through;
  const Town town({road(1, west, 1, 2), road(2, {{0, 0, 0}, {100, -8, 0}}, 1, 0), marked});
  EXPECT_EQ(plausible(town, town.join(), 3, 2), (Ranks{{1, 1}}));
}

TEST(Plausible, ADeadEndTurnsBackBesideTheOtherDirection) {
  InterconnectionSettings settings;
  settings.u_turn = true;
  const Town town({road(1, west, 2, 2)});
  EXPECT_EQ(plausible(town, town.join({}, settings), 1, 1).count({1, 1}), 1u);
}

// Into the lane at the kerb where it can, else into the next.
TEST(Plausible, ATightTurnTakesTheNextLane) {
  for (const double radius : {1., 2., 4., 8., 12.}) {
    const Town town = crossing(3, radius);
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

// At 110 km/h a turn needs 7 m, and the one about the nose between 2 and 3 has less on either lane:
// the lane of 2 that it alone took is left to 1.
TEST(Plausible, ATightTurnGivesWayToAWideOne) {
  std::vector<Road> roads{road(1, west, 1, 1), road(2, {{0, 0, 0}, {100, 20, 0}}, 2, 0),
                          road(3, {{85, -60, 0}, {0, 0, 0}}, 1, 0)};
  for (Road& r : roads) r.speed = 110;
  const Town town(roads, 0.5);
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
  const Town town({{1, west, general(1, turn::through), {}, 3.5, 50},
                   road(2, south, 1, 0),
                   road(3, {{0, 0, 0}, {100, 0, 0}}, 3, 0)});
  const auto all = town.join();
  EXPECT_EQ(plausible(town, all, 1, 3), (Ranks{{1, 1}, {1, 2}}));
  EXPECT_EQ(plausible(town, all, 2, 3), (Ranks{{1, 3}}));
}

TEST(Plausible, EveryLaneLeadsOnAndIsReachedWhereAnotherStreetAllows) {
  for (unsigned seed = 1; seed <= 400; ++seed) {
    const Town town(Star(seed).roads());
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
  for (unsigned seed = 1; seed <= 400; ++seed) {
    const Town town(Star(seed).roads());
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
    std::vector<Road> roads = Star(seed).roads();
    const Town town(roads);
    std::reverse(roads.begin(), roads.end());
    const Town other(roads);
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

}  // namespace
}  // namespace streetgen
