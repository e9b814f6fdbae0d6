#include "streetgen/traffic_event.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "rounds.hpp"
#include "simulation/made_network.hpp"
#include "streetgen/car_following.hpp"
#include "streetgen/error.hpp"
#include "streetgen/simulation.hpp"

namespace streetgen {
namespace traffic_event_test {
namespace {

using simulation_test::NetworkMaker;

constexpr double step = 0.1;

// Two lanes beside each other, and lanes that they lead to.
struct Road {
  int right, left;
  TrafficNetwork network;
};

Road made_road() {
  NetworkMaker maker;
  Road road;
  road.right = maker.lane(1500);
  road.left = maker.lane(1500);
  maker.movement(road.right, maker.lane(300), 10, 14);
  maker.movement(road.left, maker.lane(300), 10, 14);
  maker.lanes_beside(road.right, road.left, 0, 1500);
  road.network = maker.network();
  return road;
}

Car car_at(int link, double metres, std::int64_t car_id, double speed = 14) {
  Car car;
  car.car_id = car_id;
  car.place = {link, metres};
  car.speed = speed;
  return car;
}

TrafficEvent event_at(const Road& road, EventKind kind, EventTrigger trigger, double metres,
                      double at = 0) {
  TrafficEvent event;
  event.event_id = 7;
  event.kind = kind;
  event.trigger = trigger;
  event.place = {road.right, metres};
  event.at = at;
  return event;
}

// Follows the car of index 0 until the event fired, and some time longer.
struct Told {
  double came = -1;  // when the trigger came: at the end of that step
  FiredEvent fired;
  std::size_t count = 0;
  double least_speed = 1e9, hardest = 0, farthest = 0;
};

Told follow(CarFollowing& cars, const TrafficEvent& event, double seconds) {
  Told told;
  double before = cars.traffic().car(0).place.metres;
  double end = std::numeric_limits<double>::infinity();
  while (cars.time() < std::min(end, 200.0)) {
    cars.step(step);
    const Car car = cars.traffic().car(0);
    const double now = car.place.metres;
    const bool came = event.trigger == EventTrigger::time ? cars.time() >= event.at
                      : event.trigger == EventTrigger::place
                          ? before < event.place.metres && now >= event.place.metres
                          : event.place.metres - now <= event.at;
    if (came && told.came < 0) told.came = cars.time();
    before = now;
    if (cars.fired().empty()) continue;
    if (told.count == 0) end = cars.time() + seconds;
    told.count = cars.fired().size();
    told.fired = cars.fired()[0];
    told.least_speed = std::min(told.least_speed, car.speed);
    told.hardest = std::min(told.hardest, cars.acceleration(0));
    told.farthest = now;
  }
  return told;
}

class Events : public ::testing::TestWithParam<EventKind> {};

// At many places, by each trigger: once, within a step.
TEST_P(Events, FireOnceWithinAStepOfTheirTrigger) {
  const Road road = made_road();
  std::mt19937_64 random(5);
  for (int round = 0; round < rounds(40); ++round)
    for (const EventTrigger trigger : {EventTrigger::time, EventTrigger::place, EventTrigger::gap}) {
      CarFollowing cars(road.network, {});
      const double metres = 200 + random() % 8000 / 10.0;
      const double at = trigger == EventTrigger::time ? 1 + random() % 100 / 10.0
                                                      : 20 + random() % 600 / 10.0;
      const TrafficEvent event = event_at(road, GetParam(), trigger, metres, at);
      cars.set_events({event});
      cars.add(car_at(road.right, 20, 1));
      const Told told = follow(cars, event, 3);
      ASSERT_EQ(told.count, 1U) << round;
      EXPECT_EQ(told.fired.event_id, 7);
      // Where a car has just passed, another one pulls out half a metre behind its rear.
      const bool waits = GetParam() == EventKind::pull_out && trigger == EventTrigger::place;
      EXPECT_NEAR(told.fired.time, told.came, step + 1e-9 + (waits ? 5.5 / 13 : 0));
      EXPECT_EQ(cars.fired().size(), 1U);
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, Events,
                         ::testing::Values(EventKind::brake, EventKind::breakdown,
                                           EventKind::overtake, EventKind::pull_out,
                                           EventKind::cross));

TEST(Event, BrakesToItsSpeedForItsTime) {
  const Road road = made_road();
  CarFollowing cars(road.network, {});
  TrafficEvent event = event_at(road, EventKind::brake, EventTrigger::place, 300);
  event.speed = 4;
  event.deceleration = 3;
  event.duration = 10;
  cars.set_events({event});
  cars.add(car_at(road.right, 20, 1));
  const Told told = follow(cars, event, 9.9);
  EXPECT_EQ(told.fired.car_id, 1);
  EXPECT_NEAR(told.least_speed, 4, 1e-9);
  EXPECT_NEAR(told.hardest, -3, 1e-9);
  EXPECT_NEAR(cars.traffic().car(0).speed, 4, 1e-9);
  for (int i = 0; i < 100; ++i) cars.step(step);
  EXPECT_GT(cars.traffic().car(0).speed, 8) << "then it goes on";
}

TEST(Event, BreaksDownForGood) {
  const Road road = made_road();
  CarFollowing cars(road.network, {});
  TrafficEvent event = event_at(road, EventKind::breakdown, EventTrigger::time, 300, 5);
  event.car_id = 1;
  event.duration = std::numeric_limits<double>::infinity();
  cars.set_events({event});
  cars.add(car_at(road.right, 100, 1));
  cars.add(car_at(road.right, 20, 2));
  for (int i = 0; i < 600; ++i) cars.step(step);
  EXPECT_EQ(cars.traffic().car(0).speed, 0);
  EXPECT_GT(cars.traffic().car(1).place.metres, cars.traffic().car(0).place.metres + 100)
      << "who comes after passes on the lane beside";
}

TEST(Event, OvertakesOnTheLaneForPassing) {
  const Road road = made_road();
  CarFollowing cars(road.network, {});
  TrafficEvent slow = event_at(road, EventKind::brake, EventTrigger::time, 300);
  slow.car_id = 2;
  slow.speed = 10;
  slow.duration = 100;
  TrafficEvent event = event_at(road, EventKind::overtake, EventTrigger::time, 200, 0.2);
  event.car_id = 1;
  event.speed = 5;
  event.duration = 30;
  cars.set_events({slow, event});
  cars.add(car_at(road.right, 20, 1));
  cars.add(car_at(road.right, 90, 2, 10));
  bool on_left = false;
  double fastest = 0;
  for (int i = 0; i < 400; ++i) {
    cars.step(step);
    on_left |= cars.traffic().car(0).place.link == road.left;
    fastest = std::max(fastest, cars.traffic().car(0).speed);
  }
  EXPECT_TRUE(on_left);
  EXPECT_GT(fastest, 14.5);
  EXPECT_GT(cars.traffic().car(0).place.metres, cars.traffic().car(1).place.metres);
}

TEST(Event, StopsWhoCanForSomebodyWhoCrosses) {
  const Road road = made_road();
  for (const double gap : {60.0, 8.0}) {
    CarFollowing cars(road.network, {});
    TrafficEvent event = event_at(road, EventKind::cross, EventTrigger::gap, 400, gap);
    event.duration = 20;
    cars.set_events({event});
    cars.add(car_at(road.right, 20, 1));
    const Told told = follow(cars, event, 19);
    if (gap > 20) {
      EXPECT_LE(told.farthest, 399 + 1e-6) << "it waits";
      EXPECT_EQ(cars.traffic().car(0).speed, 0);
      EXPECT_GE(told.hardest, -9);
      for (int i = 0; i < 100; ++i) cars.step(step);
      EXPECT_GT(cars.traffic().car(0).place.metres, 410) << "and goes on";
    } else {
      EXPECT_GT(told.farthest, 450) << "it cannot stop, and passes";
    }
  }
}

TEST(Event, PullsOutBeforeWhoCanStop) {
  const Road road = made_road();
  CarFollowing cars(road.network, {});
  const TrafficEvent event = event_at(road, EventKind::pull_out, EventTrigger::gap, 400, 40);
  cars.set_events({event});
  cars.add(car_at(road.right, 20, 1));
  const Told told = follow(cars, event, 30);
  ASSERT_EQ(cars.traffic().count(), 2);
  EXPECT_GE(told.hardest, -9);
  EXPECT_GT(cars.traffic().car(1).place.metres, 410) << "it drives off";
  EXPECT_EQ(cars.entered(), 1);
}

TEST(Event, IsForItsCarAlone) {
  const Road road = made_road();
  for (const std::int64_t car_id : {-7, -1, 0, 2}) {
    CarFollowing cars(road.network, {});
    TrafficEvent event = event_at(road, EventKind::brake, EventTrigger::place, 300);
    event.car_id = car_id;
    cars.set_events({event});
    cars.add(car_at(road.right, 120, 1));
    for (int i = 0; i < 200; ++i) cars.step(step);
    EXPECT_TRUE(cars.fired().empty()) << "it is for car " << car_id;
    cars.add(car_at(road.right, 20, car_id));
    for (int i = 0; i < 250; ++i) cars.step(step);
    ASSERT_EQ(cars.fired().size(), 1U) << car_id;
    EXPECT_EQ(cars.fired()[0].car_id, car_id);
  }
}

// At either end of a link, and where cars enter.
TEST(Event, ComesAtBothEndsOfALink) {
  const Road road = made_road();
  const int movement = road.network.links[road.right].straight_on;
  const int lane = road.network.links[movement].straight_on;
  for (const LinkPlace place : {LinkPlace{road.right, 1500}, LinkPlace{movement, 0},
                                LinkPlace{movement, 10}, LinkPlace{lane, 0}}) {
    CarFollowing cars(road.network, {});
    TrafficEvent event = event_at(road, EventKind::brake, EventTrigger::place, 0);
    event.place = place;
    cars.set_events({event});
    cars.add(car_at(road.right, 1450, 1));
    for (int i = 0; i < 100; ++i) cars.step(step);
    EXPECT_EQ(cars.fired().size(), 1U) << place.link << " " << place.metres;
  }
  for (const double metres : {0., 2., 5.}) {
    CarFollowing cars(road.network, {});
    cars.set_entries({{road.right, 0.2}});
    cars.set_events({event_at(road, EventKind::brake, EventTrigger::place, metres)});
    for (int i = 0; i < 100; ++i) cars.step(step);
    EXPECT_EQ(cars.fired().size(), 1U) << metres;
  }
}

// The rear of a long vehicle is on the lane yet whose front has left it.
TEST(Event, PullsOutBehindALongVehicle) {
  const Road road = made_road();
  const int movement = road.network.links[road.right].straight_on;
  CarFollowing cars(road.network, {});
  TrafficEvent stop = event_at(road, EventKind::breakdown, EventTrigger::time, 0);
  stop.car_id = 1;
  stop.duration = 20;
  cars.set_events({stop, event_at(road, EventKind::pull_out, EventTrigger::time, 1490, 1)});
  Car bus = car_at(movement, 4, 1, 0);
  bus.length = 30;
  cars.add(bus);
  for (int i = 0; i < 190; ++i) cars.step(step);
  EXPECT_EQ(cars.fired().size(), 1U) << "the bus stands there";
  for (int i = 0; i < 200; ++i) cars.step(step);
  ASSERT_EQ(cars.fired().size(), 2U) << "then it goes on";
  EXPECT_GT(cars.fired()[1].time, 20);
}

TEST(Event, RefusesWhatCannotHappen) {
  const Road road = made_road();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const TrafficEvent good = event_at(road, EventKind::brake, EventTrigger::time, 300);
  CarFollowing cars(road.network, {});
  EXPECT_NO_THROW(cars.set_events({good}));
  const auto refused = [&](auto change) {
    TrafficEvent event = good;
    change(event);
    EXPECT_THROW(cars.set_events({event}), Error);
  };
  refused([](TrafficEvent& e) { e.place.link = -1; });
  refused([](TrafficEvent& e) { e.place.metres = 1e4; });
  refused([&](TrafficEvent& e) { e.at = nan; });
  refused([](TrafficEvent& e) { e.speed = -1; });
  refused([](TrafficEvent& e) { e.deceleration = 0; });
  refused([&](TrafficEvent& e) { e.duration = nan; });
  refused([](TrafficEvent& e) {
    e.kind = EventKind::pull_out;
    e.place = {3, 5};
  });
  refused([](TrafficEvent& e) {
    e.kind = EventKind::pull_out;
    e.place.metres = 5.4;
  });
  SimulationDemand demand;
  demand.events = {good};
  SimulationOptions options;
  options.method = SimulationMethod::lwr;
  EXPECT_THROW(simulate(road.network, demand, options, {}), Error);
}

}  // namespace
}  // namespace traffic_event_test
}  // namespace streetgen
