#include "streetgen/car_following.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <utility>

#include "made_town.hpp"
#include "streetgen/error.hpp"

namespace streetgen {
namespace car_following_test {

using simulation_test::expect_nobody_meets;
using simulation_test::NetworkMaker;

Car car_at(int link, double metres, double speed, std::int64_t id = 1) {
  Car car;
  car.car_id = id;
  car.place = {link, metres};
  car.speed = speed;
  return car;
}

// A lane that ends at a signal which stays red.
TrafficNetwork red_light(double speed) {
  NetworkMaker made;
  const int in = made.lane(1200, static_cast<float>(speed)), out = made.lane(50);
  const int ahead = made.movement(in, out, 20);
  made.plans.push_back({1, 100, 0});
  made.signal(ahead, 0, {{0, Aspect::red}});
  return made.network();
}

// The place of a car that comes to red after a while, and the hardest braking until then.
struct Stop {
  double metres = 0, speed = 0, hardest = 0;
};

Stop stop_at_red(double speed, double step, double seconds, int queue = 0) {
  const TrafficNetwork network = red_light(speed);
  CarFollowing cars(network, {});
  for (int i = 0; i < queue; ++i) cars.add(car_at(0, 1198 - 7 * i, 0, 100 + i));
  const int car = cars.add(car_at(0, 10, speed));
  Stop stop;
  const int steps = static_cast<int>(seconds / step + 0.5);
  for (int i = 0; i < steps; ++i) {
    cars.step(step);
    const Car now = cars.traffic().car(car);
    EXPECT_LE(now.place.metres, 1200 - (queue > 0 ? 2 + 7 * queue - 2 : 0));
    stop.hardest = std::min(stop.hardest, cars.acceleration(car));
    stop.metres = now.place.metres;
    stop.speed = now.speed;
  }
  return stop;
}

TEST(CarFollowing, StopsAtRedAndBehindAJam) {
  for (const double kmh : {50, 120})
    for (const double step : {0.1, 0.05})
      for (const int queue : {0, 20}) {
        const Stop stop = stop_at_red(kmh / 3.6, step, 300, queue);
        EXPECT_LT(stop.speed, 0.02);
        EXPECT_NEAR(stop.metres, 1198 - 7 * queue, 0.25);
        // No more than comfortable braking and what the last metres need.
        EXPECT_GT(stop.hardest, -2) << kmh;
      }
}

TEST(CarFollowing, StopsConvergeWithFirstOrder) {
  for (const double kmh : {50, 120}) {
    const double seconds = 1100 / (kmh / 3.6);
    const double exact = stop_at_red(kmh / 3.6, 0.0015625, seconds).metres;
    const double coarse = std::abs(stop_at_red(kmh / 3.6, 0.1, seconds).metres - exact);
    const double fine = std::abs(stop_at_red(kmh / 3.6, 0.0125, seconds).metres - exact);
    EXPECT_GT(std::log2(coarse / fine) / 3, 0.95) << coarse << " " << fine;
  }
}

// So many cars on a ring, after all have the same speed.
CarFollowing ring(const TrafficNetwork& network, int count, double seconds) {
  CarFollowing cars(network, {});
  const double length = network.links[0].length;
  for (int i = 0; i < count; ++i) cars.add(car_at(0, length * (i + 0.5) / count, 10, i + 1));
  while (cars.time() < seconds) cars.step(0.1);
  return cars;
}

TrafficNetwork ring_road(double length, double speed) {
  NetworkMaker made;
  made.lane(length - 10, static_cast<float>(speed));
  made.movement(0, 0, 10, static_cast<float>(speed));
  return made.network();
}

TEST(CarFollowing, RingHasTheGapOfTheClosedForm) {
  const TrafficNetwork network = ring_road(1010, 50 / 3.6);
  const CarFollowing cars = ring(network, 20, 3000);
  for (int i = 0; i < 20; ++i) {
    const double gap = idm_equilibrium_gap({}, cars.traffic().car(i).speed, network.links[0].speed);
    EXPECT_NEAR(gap, 1010. / 20 - 5, 1e-3 * gap);
  }
  EXPECT_NEAR(cars.traffic().car(0).speed, 12.931, 0.005);
}

TEST(CarFollowing, RingHasTheCapacityOfTheClosedForm) {
  const TrafficNetwork network = ring_road(2000, 33);
  double most = 0;
  for (int count = 40; count <= 64; count += 4) {
    CarFollowing cars = ring(network, count, 400);
    const std::int64_t before = cars.passed(1);
    for (int i = 0; i < 6000; ++i) cars.step(0.1);
    most = std::max(most, (cars.passed(1) - before) * 3600. / 600);
  }
  EXPECT_NEAR(most, 1740, 0.02 * 1740);
}

// A street crosses another one and ends, behind 30 m, at a signal that stays red.
TEST(CarFollowing, NobodyEntersWithoutRoomBehind) {
  for (const double length : {12., 30., 50.}) {
    NetworkMaker made;
    const int in = made.lane(300, 14), out = made.lane(length, 14), last = made.lane(40, 14);
    const int side = made.lane(300, 14), away = made.lane(300, 14);
    const int ahead = made.movement(in, out, 15, 14), cross = made.movement(side, away, 15, 14);
    const int stopped = made.movement(out, last, 10, 14);
    made.plans.push_back({1, 100, 0});
    made.signal(stopped, 0, {{0, Aspect::red}});
    made.conflict(ahead, 5, 15, cross, 5, 15);
    const TrafficNetwork network = made.network();
    CarFollowing cars(network, {});
    cars.set_entries({{in, 0.2, -1}, {side, 0.2, -1}});
    while (cars.time() < 400) {
      cars.step(0.1);
      for (int car = cars.traffic().foremost(ahead); car >= 0; car = cars.traffic().behind(car))
        ASSERT_GT(cars.traffic().car(car).speed, 0.1) << cars.time();
    }
    EXPECT_EQ(cars.passed(out), static_cast<int>(length / 7.5));
    EXPECT_GT(cars.passed(away), 60);
  }
}

// Who was let in waits 100 s for a car that stands in its way, and for a signal behind it that
// stays red.  Then it goes where it was let in, and not by the other turn, where a car stands for
// ever.
TEST(CarFollowing, TurnsElsewhereOnlyWhereItWasNotLetIn) {
  for (int seed = 1; seed <= 8; ++seed) {
    NetworkMaker made;
    const int in = made.lane(60, 14), close = made.lane(7.5, 14), away = made.lane(100, 14);
    const int first = made.movement(in, close, 0.1), other = made.movement(in, away, 12);
    const int last = made.lane(40, 14);
    made.plans = {{1, 1000, 0}};
    made.signal(made.movement(close, last, 10), 0, {{0, Aspect::red}});
    int full[2], cross[2];
    for (int i = 0; i < 2; ++i) {
      full[i] = made.lane(6, 14);
      cross[i] = made.movement(made.lane(60, 14), full[i], 10);
      const int leaves = made.movement(full[i], last, 10);
      made.signal(leaves, 0, {{0, Aspect::red}});
      if (i == 0) made.signal(leaves, 0, {{0, Aspect::red}, {100, Aspect::protected_green}});
    }
    made.conflict(cross[0], 0, 9.5, first, 0, 0.1);
    made.conflict(cross[1], 0, 9.5, other, 3, 12);
    const TrafficNetwork network = made.network();
    CarFollowing cars(network, {}, seed);
    cars.set_turns({{in, first, 1}, {in, other, 1}});
    for (int i = 0; i < 2; ++i) {
      cars.add(car_at(full[i], 5.9, 0, 1 + i));
      cars.add(car_at(cross[i], 9, 0, 3 + i));
    }
    cars.add(car_at(in, 30, 0, 5));
    while (cars.time() < 300) {
      cars.step(0.1);
      expect_nobody_meets(cars.traffic(), cars.time());
      if (HasFatalFailure()) return;
    }
  }
}

TEST(CarFollowing, EntersAtGreenAndAmberAlone) {
  NetworkMaker made;
  const int in = made.lane(400, 14), out = made.lane(300, 14);
  const int side = made.lane(400, 14), away = made.lane(300, 14);
  const int ahead = made.movement(in, out, 20, 14), cross = made.movement(side, away, 20, 14);
  made.green(ahead, 60, 0, 25, 28);
  made.green(cross, 60, 30, 54, 57);
  made.conflict(ahead, 5, 17, cross, 5, 17, Precedence::by_signal);
  const TrafficNetwork network = made.network();
  CarFollowing cars(network, {});
  cars.set_entries({{in, 0.1, -1}, {side, 0.1, -1}});
  std::int64_t before[2] = {0, 0};
  while (cars.time() < 900) {
    const Aspect shown[2] = {aspect_at(network, ahead, cars.time()),
                             aspect_at(network, cross, cars.time())};
    cars.step(0.1);
    for (int i = 0; i < 2; ++i) {
      const std::int64_t passed = cars.passed(i == 0 ? ahead : cross);
      if (passed > before[i]) {
        EXPECT_NE(shown[i], Aspect::red) << cars.time();
      }
      before[i] = passed;
    }
  }
  EXPECT_GT(cars.passed(ahead), 0.9 * 0.1 * 900);
  EXPECT_GT(cars.passed(cross), 0.9 * 0.1 * 900);
}

TEST(CarFollowing, MinorTrafficWaitsForAGap) {
  NetworkMaker made;
  const int major = made.lane(400, 14), through = made.lane(400, 14);
  const int minor = made.lane(200, 14), away = made.lane(200, 14);
  const int first = made.movement(major, through, 16, 14);
  const int cross = made.movement(minor, away, 16, 8);
  const int merge = made.movement(minor, through, 14, 8);
  made.conflict(first, 4, 15, cross, 4, 15);
  made.conflict(first, 6, 16, merge, 3, 14);
  const TrafficNetwork network = made.network();
  CarFollowing cars(network, {});
  cars.set_entries({{major, 0.15, -1}, {minor, 0.1, -1}});
  cars.set_turns({{minor, cross, 1}, {minor, merge, 1}});
  double hardest = 0;
  while (cars.time() < 1200) {
    cars.step(0.1);
    for (const int link : {major, first})
      for (int car = cars.traffic().foremost(link); car >= 0; car = cars.traffic().behind(car))
        hardest = std::min(hardest, cars.acceleration(car));
  }
  EXPECT_GT(hardest, -3);
  EXPECT_NEAR(cars.passed(first), 0.15 * 1200, 12);
  EXPECT_GT(cars.passed(cross), 0.025 * 1200);
  EXPECT_GT(cars.passed(merge), 0.025 * 1200);
}

TEST(CarFollowing, RampsMerge) {
  NetworkMaker made;
  const int motorway = made.lane(600, 30), ramp = made.lane(150, 20);
  const int beside = made.lane(250, 30), merging = made.lane(250, 30), on = made.lane(600, 30);
  made.movement(motorway, beside, 5, 30);
  made.movement(ramp, merging, 5, 20);
  made.movement(beside, on, 5, 30);
  made.lanes_beside(merging, beside, 0, 250, true, false);
  const TrafficNetwork network = made.network();
  CarFollowing cars(network, {});
  cars.set_entries({{motorway, 0.2, -1}, {ramp, 0.1, -1}});
  while (cars.time() < 900) {
    cars.step(0.1);
    expect_nobody_meets(cars.traffic(), cars.time());
  }
  EXPECT_GT(cars.passed(on), 0.9 * 0.3 * 900 - 30);
  EXPECT_LE(cars.traffic().count(), 40);
}

TEST(CarFollowing, TakesTheFreerLane) {
  NetworkMaker made;
  const int right = made.lane(800, 14), left = made.lane(800, 14), out = made.lane(100, 14),
            out_left = made.lane(100, 14);
  const int ahead = made.movement(right, out, 10, 14),
            beside = made.movement(left, out_left, 10, 14);
  made.lanes_beside(right, left, 0, 800);
  made.green(ahead, 60, 0, 27, 30);
  made.green(beside, 60, 0, 27, 30);
  const TrafficNetwork network = made.network();
  CarFollowing cars(network, {});
  cars.set_entries({{right, 0.35, -1}});
  while (cars.time() < 900) {
    cars.step(0.1);
    expect_nobody_meets(cars.traffic(), cars.time());
  }
  EXPECT_GT(cars.passed(beside), 0.2 * cars.passed(ahead));
  EXPECT_GT(cars.passed(ahead), 0.2 * cars.passed(beside));
}

TEST(CarFollowing, KeepsToTheSideOfItsTraffic) {
  for (const bool left_hand : {false, true}) {
    NetworkMaker made;
    const int right = made.lane(800, 14), left = made.lane(800, 14), out = made.lane(100, 14),
              out_left = made.lane(100, 14);
    const int ahead = made.movement(right, out, 10, 14),
              beside = made.movement(left, out_left, 10, 14);
    made.lanes_beside(right, left, 0, 800);
    TrafficNetwork network = made.network();
    network.left_hand = left_hand;
    CarFollowing cars(network, {});
    cars.set_entries({{right, 0.15, -1}, {left, 0.15, -1}});
    while (cars.time() < 900) cars.step(0.1);
    const auto on_side = cars.passed(left_hand ? beside : ahead);
    const auto on_other = cars.passed(left_hand ? ahead : beside);
    EXPECT_GT(on_side, on_other) << left_hand;
  }
}

TEST(CarFollowing, ChangesNoLaneTwiceAtOnce) {
  NetworkMaker made;
  const int right = made.lane(800, 14), left = made.lane(800, 14), out = made.lane(100, 14),
            out_left = made.lane(100, 14);
  const int ahead = made.movement(right, out, 10, 14),
            beside = made.movement(left, out_left, 10, 14);
  made.lanes_beside(right, left, 0, 800);
  made.green(ahead, 60, 0, 20, 23);
  made.green(beside, 60, 30, 50, 53);
  const TrafficNetwork network = made.network();
  CarFollowing cars(network, {});
  cars.set_entries({{right, 0.4, -1}});
  std::map<int, std::pair<int, double>> since;  // the lane of each car, and when it came there
  int changes = 0;
  while (cars.time() < 600) {
    cars.step(0.1);
    for (const int lane : {right, left})
      for (int c = cars.traffic().foremost(lane); c >= 0; c = cars.traffic().behind(c)) {
        const auto [known, fresh] = since.emplace(c, std::pair(lane, -100.));
        if (fresh || known->second.first == lane) continue;
        EXPECT_GE(cars.time() - known->second.second, LaneChangeRules().rest - 0.2);
        known->second = {lane, cars.time()};
        ++changes;
      }
    for (auto it = since.begin(); it != since.end();) {
      const bool gone = !cars.traffic().holds(it->first) ||
                        (cars.traffic().car(it->first).place.link != right &&
                         cars.traffic().car(it->first).place.link != left);
      it = gone ? since.erase(it) : std::next(it);
    }
  }
  EXPECT_GT(changes, 20);
}

TEST(CarFollowing, ChangesLanesForItsRoute) {
  NetworkMaker made;
  const int right = made.lane(500, 14), left = made.lane(500, 14);
  const int exit = made.lane(200, 14), on = made.lane(200, 14);
  const int leaves = made.movement(left, exit, 10, 14);
  made.movement(right, on, 10, 14);
  made.lanes_beside(right, left, 0, 500);
  const TrafficNetwork network = made.network();
  CarFollowing cars(network, {});
  cars.set_routes({{right, left, leaves, exit}, {right, 5, on}});
  cars.set_entries({{right, 0.1, 0}, {right, 0.1, 1}});
  while (cars.time() < 600) cars.step(0.1);
  cars.set_entries({});
  while (cars.time() < 900) cars.step(0.1);
  EXPECT_EQ(cars.traffic().count(), 0);
  EXPECT_NEAR(cars.passed(exit), 60, 3);
  EXPECT_NEAR(cars.passed(on), 60, 3);
}

TEST(CarFollowing, DrivesByALawOfOnesOwn) {
  const TrafficNetwork network = red_light(14);
  DrivingRules rules;
  const DriverModel model;
  rules.law = [&](const std::vector<Following>& asked, std::vector<double>& given) {
    for (std::size_t i = 0; i < asked.size(); ++i) given[i] = idm_acceleration(model, asked[i]);
  };
  CarFollowing own(network, rules), known(network, {});
  own.add(car_at(0, 20, 14));
  known.add(car_at(0, 20, 14));
  for (int i = 0; i < 1000; ++i) {
    own.step(0.1);
    known.step(0.1);
    ASSERT_EQ(own.traffic().car(0).place.metres, known.traffic().car(0).place.metres);
  }
  // Even a law that knows no gap meets nobody.
  rules.law = [](const std::vector<Following>& asked, std::vector<double>& given) {
    given.assign(asked.size(), 1);
  };
  CarFollowing wild(network, rules);
  wild.set_entries({{0, 0.5, -1}});
  while (wild.time() < 200) {
    wild.step(0.1);
    expect_nobody_meets(wild.traffic(), wild.time());
  }
  EXPECT_EQ(wild.left(), 0);
}

void refused(const std::function<void()>& task, const std::string& word) {
  try {
    task();
    ADD_FAILURE() << "nothing was refused: " << word;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
    EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
  }
}

TEST(CarFollowing, RefusesBadInput) {
  const TrafficNetwork network = red_light(14);
  CarFollowing cars(network, {});
  refused([&] { cars.step(0); }, "step 0");
  refused([&] { cars.step(3600); }, "3600");
  refused([&] { cars.step(std::nan("")); }, "nan");
  refused([&] { cars.add(car_at(0, 5000, 0)); }, "5000");
  refused([&] { cars.add(car_at(0, 20, -1)); }, "-1");
  cars.add(car_at(0, 100, 5, 7));
  refused([&] { cars.add(car_at(0, 102, 5, 8)); }, "cars 8 and 7");
  EXPECT_EQ(cars.traffic().count(), 1);
  refused([&] { cars.set_routes({{0, 1}}); }, "");
  refused([&] { cars.set_entries({{0, 1, 3}}); }, "route 3");
  refused([&] { cars.set_entries({{9, 1, -1}}); }, "9");
  DrivingRules rules;
  rules.horizon = 1e9;
  refused([&] { CarFollowing(network, rules); }, "horizon");
  rules = {};
  rules.driver.acceleration = 0;
  refused([&] { CarFollowing(network, rules); }, "acceleration");
  for (int i = 0; i < 10; ++i) cars.step(0.1);
}

// The inner lane of a ring has no way out; its outer one has.
TEST(CarFollowing, LeavesALaneFromWhichNoWayLeadsOut) {
  NetworkMaker maker;
  const int inner = maker.lane(100), outer = maker.lane(100), exit = maker.lane(50);
  maker.movement(inner, inner, 10);
  maker.movement(outer, exit, 10);
  maker.beside(inner, {outer, false, true, false, 0, 100, 0, 100});
  maker.beside(outer, {inner, true, true, false, 0, 100, 0, 100});
  const TrafficNetwork network = maker.network();
  CarFollowing cars(network, {});
  for (const int lane : {inner, outer}) {
    Car car;
    car.car_id = lane;
    car.place = {lane, 20};
    cars.add(car);
  }
  for (int i = 0; i < 600; ++i) cars.step(0.1);
  EXPECT_EQ(cars.left(), 2);
}

// Nine of ten turn where the lane is full before a red; who waits there goes where room is.
TEST(CarFollowing, WhoFindsNoRoomTurnsWhereThereIsSome) {
  NetworkMaker maker;
  const int from = maker.lane(60), full = maker.lane(12), beyond = maker.lane(50),
            free = maker.lane(50), across = maker.lane(50), end = maker.lane(50);
  const int to_full = maker.movement(from, full, 8), to_free = maker.movement(from, free, 8);
  const int crossing = maker.movement(across, end, 8), red = maker.movement(full, beyond, 8);
  maker.conflict(to_full, 0, 8, crossing, 0, 8);
  maker.conflict(to_free, 0, 8, crossing, 0, 8);
  maker.signal(red, 0, {{0, Aspect::red}});
  maker.plans.push_back({1, 60, 0});
  const TrafficNetwork network = maker.network();
  CarFollowing cars(network, {});
  cars.set_turns({{from, to_full, 9}, {from, to_free, 1}});
  Car car;
  car.place = {full, 10};
  cars.add(car);
  for (int i = 1; i <= 3; ++i) {
    car.car_id = i;
    car.place = {from, 15.0 * i};
    cars.add(car);
  }
  for (int i = 0; i < 1800; ++i) cars.step(0.1);
  EXPECT_EQ(cars.left(), 3);
  EXPECT_EQ(cars.traffic().count(), 1);
}

}  // namespace car_following_test
}  // namespace streetgen
