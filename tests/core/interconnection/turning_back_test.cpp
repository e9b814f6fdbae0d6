// What turns back, and what only turns sharply.
#include <gtest/gtest.h>

#include <cmath>

#include "interconnection/joined_town.hpp"

namespace streetgen {
namespace turning_back_test {

Point at(double degrees, double reach) {
  return {reach * std::cos(degrees * M_PI / 180), reach * std::sin(degrees * M_PI / 180), 0};
}

std::set<std::string> turns(const JoinedTown& town, const std::vector<Interconnection>& all,
                            std::int64_t from, std::int64_t to) {
  std::set<std::string> found;
  for (const Interconnection& i : all)
    if (town.axis_of(i.lane_in) == from && town.axis_of(i.lane_out) == to)
      found.insert(turn_name(i.turn));
  return found;
}

// The arm leaves to the north and bends to either side where it is clear of the other street.
TEST(TurningBack, AnArmThatBendsBehindAJunctionKeepsAllMovements) {
  for (const double bend : {60., 75., 90., -60., -75., -90.})
    for (const double behind : {8., 9., 12., 16., 20.}) {
      const Point knee{0, behind, 0};
      const JoinedTown town({road(1, west, 1, 1), road(2, east, 1, 1),
                             road(3, {{0, 0, 0}, knee, knee + at(90 + bend, 80)}, 1, 1)});
      const auto all = town.join();
      for (int from = 1; from <= 3; ++from)
        for (int to = 1; to <= 3; ++to) {
          if (from == to) continue;
          EXPECT_EQ(plausible(town, all, from, to), (Ranks{{1, 1}}))
              << bend << " degrees at " << behind << " m, from " << from << " to " << to;
          EXPECT_EQ(turns(town, all, from, to).count("u_turn"), 0u);
        }
    }
}

// A street of both directions parts into its two carriageways.
JoinedTown parting(double apart) {
  return JoinedTown({road(1, west, 1, 1), road(2, {{0, 0, 0}, at(-apart / 2, 120)}, 1, 0),
                     road(3, {at(apart / 2, 120), {0, 0, 0}}, 1, 0)});
}

TEST(TurningBack, NobodyTurnsRoundTheNoseWhereAStreetParts) {
  for (const double apart : {15., 20., 35., 50., 70.}) {
    const JoinedTown town = parting(apart);
    const auto all = town.join();
    EXPECT_EQ(plausible(town, all, 3, 2), Ranks{}) << apart;
    EXPECT_EQ(turns(town, all, 3, 2), (std::set<std::string>{"u_turn"})) << apart;
    EXPECT_EQ(plausible(town, all, 1, 2), (Ranks{{1, 1}})) << apart;
    EXPECT_EQ(plausible(town, all, 3, 1), (Ranks{{1, 1}})) << apart;
  }
}

TEST(TurningBack, TwoOneWayStreetsFarApartAreNoCarriageways) {
  const JoinedTown town = parting(100);
  const auto all = town.join();
  EXPECT_EQ(plausible(town, all, 3, 2), (Ranks{{1, 1}}));
  EXPECT_EQ(turns(town, all, 3, 2), (std::set<std::string>{"left"}));
}

TEST(TurningBack, AStreetThatGoesOnSharplyIsNoUTurn) {
  for (const double onwards : {150., 165., 175.}) {
    const JoinedTown town({road(1, west, 1, 1), road(2, {{0, 0, 0}, at(onwards, 100)}, 1, 1)});
    const auto all = town.join();
    EXPECT_EQ(plausible(town, all, 1, 2), (Ranks{{1, 1}})) << onwards;
    EXPECT_EQ(turns(town, all, 1, 2), (std::set<std::string>{"left"})) << onwards;
    EXPECT_EQ(turns(town, all, 2, 1), (std::set<std::string>{"right"})) << onwards;
  }
}

// The same street drawn twice, once as one-way.
TEST(TurningBack, NobodyTurnsIntoAStreetDrawnUponHisOwn) {
  const Line onwards{{0, 0, 0}, {100, 0, 0}};
  const JoinedTown town({road(1, west, 1, 1), road(2, west, 2, 0), road(3, onwards, 1, 1)});
  EXPECT_EQ(plausible(town, town.join(), 2, 1), Ranks{});
}

// The carriageways of a street end at a cross street.
TEST(TurningBack, CarriagewaysThatEndAtACrossStreetAreNotJoined) {
  const JoinedTown town({road(1, {{0, 0, 0}, at(-10, 120)}, 1, 0),
                         road(2, {at(10, 120), {0, 0, 0}}, 1, 0), road(3, north, 1, 1),
                         road(4, south, 1, 1)});
  const auto all = town.join();
  EXPECT_EQ(plausible(town, all, 2, 1), Ranks{});
  EXPECT_EQ(reasons(town, all, 2, 1), (std::set<std::string>{"u_turn"}));
}

// A lane of buses against the traffic makes no street of both directions.
TEST(TurningBack, CarsAloneTellTheDirectionsOfAStreet) {
  LanedAxis out = road(2, {{0, 0, 0}, at(-20, 120)}, 1, 1);
  out.backward.front().kind = LaneKind::bus;
  const JoinedTown town({road(1, west, 1, 1), out, road(3, {at(20, 120), {0, 0, 0}}, 1, 0)});
  EXPECT_EQ(plausible(town, town.join(), 3, 2), Ranks{});
}

}  // namespace turning_back_test
}  // namespace streetgen
