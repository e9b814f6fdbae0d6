#include <gtest/gtest.h>

#include <cstring>

#include "made_town.hpp"
#include "rounds.hpp"
#include "streetgen/car_following.hpp"

namespace streetgen {
namespace car_town_test {

using simulation_test::expect_nobody_meets;
using simulation_test::expect_room_behind_junctions;
using simulation_test::Town;
using simulation_test::TownMaker;
using simulation_test::TownStyle;

TEST(CarTown, NobodyMeetsInRandomTowns) {
  for (int seed = 1; seed <= rounds(12); ++seed) {
    const Town town = TownMaker(seed, 2 + seed % 3, 2 + seed % 2).made();
    CarFollowing cars(town.network, {}, seed);
    cars.set_entries(town.entries);
    cars.set_turns(town.turns);
    while (cars.time() < 400) {
      cars.step(0.1);
      expect_nobody_meets(cars.traffic(), cars.time());
      if (HasFatalFailure()) {
        ADD_FAILURE() << "seed " << seed;
        return;
      }
    }
    EXPECT_GT(cars.left(), 20) << "seed " << seed;
    // No circle of waiting cars stays.
    cars.set_entries({});
    while (cars.traffic().count() > 0 && cars.time() < 4000) cars.step(0.2);
    EXPECT_EQ(cars.traffic().count(), 0) << "seed " << seed;
  }
}

// Lanes between junctions have room for one car or none, and more want to enter than can leave.
TEST(CarTown, NobodyStandsInTheWayForWantOfRoom) {
  TownStyle style;
  style.short_share = 0.6;
  style.shortest = 5;
  style.longest_short = 13;
  style.cycle = 90;
  style.least_flow = 0.1;
  style.most_flow = 0.4;
  for (int seed = 11; seed > 11 - rounds(11); --seed) {
    const Town town = TownMaker(seed, 3 + seed % 3, 3 + seed % 2, style).made();
    CarFollowing cars(town.network, {}, seed);
    cars.set_entries(town.entries);
    cars.set_turns(town.turns);
    while (cars.time() < 400) {
      cars.step(0.1);
      expect_nobody_meets(cars.traffic(), cars.time());
      expect_room_behind_junctions(cars.traffic(), cars.time());
      if (HasFatalFailure()) {
        ADD_FAILURE() << "seed " << seed;
        return;
      }
    }
    EXPECT_GT(cars.left(), 100) << "seed " << seed;
    cars.set_entries({});
    while (cars.traffic().count() > 0 && cars.time() < 4000) cars.step(0.2);
    EXPECT_EQ(cars.traffic().count(), 0) << "seed " << seed;
  }
}

// The bytes of all cars after a while.
std::uint64_t mark(std::uint64_t seed) {
  const Town town = TownMaker(3, 3, 3).made();
  CarFollowing cars(town.network, {}, seed);
  cars.set_entries(town.entries);
  cars.set_turns(town.turns);
  std::uint64_t mark = 14695981039346656037ULL;
  while (cars.time() < 120) {
    cars.step(0.1);
    for (int i = 0; i < cars.traffic().size(); ++i) {
      if (!cars.traffic().holds(i)) continue;
      const Car car = cars.traffic().car(i);
      std::uint64_t bits[2];
      std::memcpy(&bits[0], &car.place.metres, 8);
      std::memcpy(&bits[1], &car.speed, 8);
      for (const std::uint64_t b : bits) mark = (mark ^ b) * 1099511628211ULL;
    }
  }
  return mark;
}

TEST(CarTown, SameSeedGivesTheSameBytes) {
  EXPECT_EQ(mark(5), mark(5));
  EXPECT_NE(mark(5), mark(6));
}

}  // namespace car_town_test
}  // namespace streetgen
