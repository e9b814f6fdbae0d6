#include "streetgen/traffic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "rounds.hpp"
#include "simulation/made_network.hpp"
#include "streetgen/error.hpp"

namespace streetgen {
namespace simulation_test {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Car car_at(std::int64_t id, int link, double metres, double speed = 0, float length = 5) {
  Car car;
  car.car_id = id;
  car.place = {link, metres};
  car.speed = speed;
  car.length = length;
  return car;
}

std::vector<std::int64_t> order_of(const Traffic& traffic, int link) {
  std::vector<std::int64_t> ids;
  for (int c = traffic.foremost(link); c >= 0; c = traffic.behind(c))
    ids.push_back(traffic.car(c).car_id);
  return ids;
}

using Ids = std::vector<std::int64_t>;

TEST(Traffic, OrdersTheCarsOfALink) {
  NetworkMaker maker;
  const int lane = maker.lane(100), other = maker.lane(100);
  const TrafficNetwork network = maker.network();
  Traffic traffic(network);
  const int a = traffic.add(car_at(1, lane, 50));
  const int b = traffic.add(car_at(2, lane, 70));
  const int c = traffic.add(car_at(3, lane, 10));
  traffic.add(car_at(4, lane, 50));
  EXPECT_EQ(order_of(traffic, lane), (Ids{2, 1, 4, 3}));
  EXPECT_EQ(traffic.first_from(lane, 50), 3);
  EXPECT_EQ(traffic.first_from(lane, 70.5), -1);
  EXPECT_EQ(traffic.last_before(lane, 50), c);
  EXPECT_EQ(traffic.last_before(lane, 10), -1);
  traffic.move(c, {lane, 60});
  EXPECT_EQ(order_of(traffic, lane), (Ids{2, 3, 1, 4}));
  traffic.move(b, {other, 0});
  EXPECT_EQ(order_of(traffic, lane), (Ids{3, 1, 4}));
  EXPECT_EQ(order_of(traffic, other), (Ids{2}));
  traffic.remove(a);
  EXPECT_EQ(order_of(traffic, lane), (Ids{3, 4}));
  EXPECT_EQ(traffic.count(), 3);
  EXPECT_FALSE(traffic.holds(a));
  EXPECT_EQ(traffic.add(car_at(9, lane, 1)), a);
  EXPECT_EQ(order_of(traffic, lane), (Ids{3, 4, 9}));
}

TEST(Traffic, RefusesCarsThatCannotBe) {
  NetworkMaker maker;
  maker.lane(100);
  const TrafficNetwork network = maker.network();
  Traffic traffic(network);
  for (const Car& bad : {car_at(7, 0, 100.5), car_at(7, 0, -1), car_at(7, 0, nan), car_at(7, 1, 0),
                         car_at(7, -1, 0), car_at(7, 0, 5, nan), car_at(7, 0, 5, 0, 0),
                         car_at(7, 0, 5, 0, NAN), car_at(7, 0, 5, 0, 101)})
    try {
      traffic.add(bad);
      FAIL() << "taken";
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::invalid_input);
      EXPECT_EQ(std::string(e.what()).substr(0, 6), "car 7 ");
    }
  Car routed = car_at(7, 0, 5);
  routed.route = 0;
  EXPECT_THROW(traffic.add(routed), Error);
  const int kept = traffic.add(car_at(1, 0, 10));
  EXPECT_THROW(traffic.move(kept, {0, nan}), Error);
  EXPECT_THROW(traffic.set_speed(kept, nan), Error);
  EXPECT_THROW(traffic.remove(3), Error);
  EXPECT_THROW(traffic.leader(kept, {nan}), Error);
  traffic.remove(kept);
  EXPECT_THROW(traffic.car(kept), Error);
  EXPECT_EQ(traffic.count(), 0);
}

TEST(Traffic, FollowsALongCarThatHasTurnedOff) {
  NetworkMaker maker;
  const int lane = maker.lane(50), left = maker.lane(50), straight = maker.lane(50);
  maker.movement(lane, straight, 6);
  const int turn = maker.movement(lane, left, 6);
  const TrafficNetwork network = maker.network();
  Traffic traffic(network);
  const int truck = traffic.add(car_at(1, lane, 48, 5, 18));
  const int car = traffic.add(car_at(2, lane, 20, 5));
  traffic.move(truck, {turn, 4});
  EXPECT_EQ(traffic.links_under(truck), (std::vector<std::int32_t>{turn, lane}));
  traffic.move(truck, {left, 3});
  EXPECT_EQ(traffic.links_under(truck), (std::vector<std::int32_t>{left, turn, lane}));
  const Leader leader = traffic.leader(car, {});
  EXPECT_EQ(leader.car, truck);
  EXPECT_NEAR(leader.distance, 30 + 6 + 3, 1e-9);
  EXPECT_NEAR(leader.gap, 30 + 6 + 3 - 18, 1e-6);
  traffic.move(truck, {left, 13});
  EXPECT_EQ(traffic.leader(car, {}).kind, Leader::Kind::stationary);
  traffic.move(truck, {left, 30});
  EXPECT_EQ(traffic.links_under(truck), (std::vector<std::int32_t>{left}));
}

TEST(Traffic, StandsOnTheLinksOfItsRouteWhereItIsAdded) {
  NetworkMaker maker;
  const int a = maker.lane(20), b = maker.lane(20), out = maker.lane(30);
  const int from_a = maker.movement(a, out, 6), from_b = maker.movement(b, out, 6);
  const TrafficNetwork network = maker.network();
  Traffic traffic(network);
  traffic.routes = {{b, from_b, out}};
  Car car = car_at(1, out, 2, 0, 12);
  EXPECT_EQ(traffic.links_under(traffic.add(car)), (std::vector<std::int32_t>{out, from_a, a}));
  car.route = 0;
  EXPECT_EQ(traffic.links_under(traffic.add(car)), (std::vector<std::int32_t>{out, from_b, b}));
}

TEST(Traffic, LeadsByVirtualCars) {
  NetworkMaker maker;
  const int lane = maker.lane(100, 10), out = maker.lane(50, 20), beside = maker.lane(100);
  const int movement = maker.movement(lane, out, 10);
  maker.link(lane).stop = 98;
  maker.plans = {{1, 60, 10}};
  maker.signal(movement, 0, {{0, Aspect::red}, {30, Aspect::protected_green}, {50, Aspect::amber}});
  maker.beside(lane, {beside, true, true, false, 0, 100, 0, 100});
  const TrafficNetwork network = maker.network();
  Traffic traffic(network);
  const int car = traffic.add(car_at(1, lane, 40, 12));
  LeaderRules rules;
  rules.time = 10;
  Leader leader = traffic.leader(car, rules);
  EXPECT_EQ(leader.kind, Leader::Kind::stationary);
  EXPECT_DOUBLE_EQ(leader.gap, 58);
  rules.time = 40;
  leader = traffic.leader(car, rules);
  EXPECT_EQ(leader.kind, Leader::Kind::stationary) << "the lane out has no next link";
  EXPECT_DOUBLE_EQ(leader.gap, 120);
  rules.horizon = 100;
  leader = traffic.leader(car, rules);
  EXPECT_EQ(leader.kind, Leader::Kind::moving);
  EXPECT_DOUBLE_EQ(leader.gap, 100);
  EXPECT_DOUBLE_EQ(leader.speed, 20);
  rules.stationary_end = true;
  EXPECT_EQ(traffic.leader(car, rules).kind, Leader::Kind::stationary);
  rules = {};
  rules.time = -300 + 60;  // amber
  EXPECT_DOUBLE_EQ(traffic.leader(car, rules).gap, 58);
  traffic.set_speed(car, 19);
  EXPECT_DOUBLE_EQ(traffic.leader(car, rules).gap, 120) << "it cannot stop any more";
  traffic.routes = {{lane, beside}};
  traffic.set_route(car, 0);
  rules.time = 40;
  EXPECT_DOUBLE_EQ(traffic.leader(car, rules).gap, 58) << "it must change before";
  traffic.set_route(car, -1);
  traffic.move(car, {lane, 99});
  rules.time = 10;
  EXPECT_DOUBLE_EQ(traffic.leader(car, rules).gap, 61) << "it has passed the red signal";
}

TEST(Traffic, MeetsWhoComesTowards) {
  NetworkMaker maker;
  const int there = maker.lane(100), back = maker.lane(100), before = maker.lane(50);
  maker.join(before, there);
  maker.join(back, maker.lane(50));
  maker.opposite(there, back);
  const TrafficNetwork network = maker.network();
  Traffic traffic(network);
  const int car = traffic.add(car_at(1, there, 20, 10));
  const int passed = traffic.add(car_at(2, back, 85, 3));
  EXPECT_EQ(traffic.leader(car, {}).kind, Leader::Kind::stationary);
  const int towards = traffic.add(car_at(3, back, 30, 4));
  const Leader leader = traffic.leader(car, {});
  EXPECT_EQ(leader.car, towards);
  EXPECT_DOUBLE_EQ(leader.gap, 50);
  EXPECT_DOUBLE_EQ(leader.speed, -4);
  EXPECT_EQ(traffic.leader(passed, {}).kind, Leader::Kind::stationary);
  const int behind = traffic.add(car_at(4, before, 40, 4));
  EXPECT_EQ(traffic.leader(behind, {}).car, car);
  traffic.remove(car);
  EXPECT_EQ(traffic.leader(behind, {}).car, passed);
  EXPECT_DOUBLE_EQ(traffic.leader(behind, {}).gap, 25);
  traffic.move(passed, {network.links[back].straight_on, 2});
  EXPECT_EQ(traffic.leader(behind, {}).car, passed);
  EXPECT_DOUBLE_EQ(traffic.leader(behind, {}).gap, 10);
}

TEST(Traffic, SeesWhoMerges) {
  NetworkMaker maker;
  const int main = maker.lane(100), ramp = maker.lane(100), out = maker.lane(200);
  const int on = maker.movement(main, out, 10);
  const int merging = maker.movement(ramp, out, 10);
  maker.plans = {{1, 60, 0}};
  const TrafficNetwork network = maker.network();
  Traffic traffic(network);
  const int a = traffic.add(car_at(1, main, 80, 10));  // 30 m before
  const int b = traffic.add(car_at(2, ramp, 90, 5));   // 20 m before
  LeaderRules rules;
  EXPECT_EQ(traffic.leader(a, rules).kind, Leader::Kind::stationary);
  rules.merging = MergingLeader::by_place;
  Leader leader = traffic.leader(a, rules);
  EXPECT_EQ(leader.car, b);
  EXPECT_DOUBLE_EQ(leader.distance, 10);
  EXPECT_DOUBLE_EQ(leader.gap, 5);
  EXPECT_EQ(traffic.leader(b, rules).car, -1);
  rules.merging = MergingLeader::by_time;
  leader = traffic.leader(b, rules);
  EXPECT_EQ(leader.car, a);
  EXPECT_DOUBLE_EQ(leader.distance, 20 - 3 * 5);
  EXPECT_EQ(traffic.leader(a, rules).car, -1);
  rules.merging_reach = 25;
  EXPECT_EQ(traffic.leader(b, rules).car, -1);
  maker.signal(merging, 0, {{0, Aspect::red}});
  const TrafficNetwork signalled = maker.network();
  Traffic stopped(signalled);
  stopped.add(car_at(1, main, 80, 10));
  stopped.add(car_at(2, ramp, 90, 5));
  rules = {};
  rules.merging = MergingLeader::by_place;
  EXPECT_EQ(stopped.leader(0, rules).car, -1) << "red keeps it out";
  maker.signal(merging, 0, {});
  maker.signal(on, 0, {{0, Aspect::red}});
  const TrafficNetwork waiting_network = maker.network();
  Traffic waiting(waiting_network);
  waiting.add(car_at(1, main, 80, 10));
  waiting.add(car_at(2, ramp, 98, 5));
  const Leader red = waiting.leader(0, rules);
  EXPECT_EQ(red.kind, Leader::Kind::stationary) << "it stops before they meet";
  EXPECT_DOUBLE_EQ(red.gap, 20);
}

TEST(Traffic, TwoThatMergeNeverWaitForEachOther) {
  std::mt19937_64 random(5);
  for (int round = 0; round < rounds(200); ++round) {
    NetworkMaker maker;
    const int out = maker.lane(50);
    std::vector<int> lanes;
    for (int i = 0; i < 3; ++i) {
      lanes.push_back(maker.lane(40));
      maker.movement(lanes.back(), out, 5 + static_cast<double>(random() % 3));
    }
    const TrafficNetwork network = maker.network();
    for (const MergingLeader merging : {MergingLeader::by_place, MergingLeader::by_time}) {
      Traffic traffic(network);
      for (int i = 0; i < 3; ++i)
        traffic.add(car_at(i, lanes[i], 35 + static_cast<double>(random() % 3),
                           static_cast<double>(random() % 3)));
      LeaderRules rules;
      rules.merging = merging;
      for (int i = 0; i < 3; ++i) {
        int at = i;
        for (int steps = 0; at >= 0; ++steps) {
          ASSERT_LT(steps, 3) << "a circle of leaders";
          at = traffic.leader(at, rules).car;
        }
      }
    }
  }
}

TEST(Traffic, EndsOnARingAtTheHorizon) {
  NetworkMaker maker;
  const int first = maker.lane(60), second = maker.lane(40);
  maker.join(first, second);
  maker.join(second, first);
  const TrafficNetwork network = maker.network();
  Traffic traffic(network);
  const int a = traffic.add(car_at(1, first, 10, 3));
  EXPECT_EQ(traffic.leader(a, {}).kind, Leader::Kind::moving);
  EXPECT_EQ(traffic.leader(a, {}).gap, 1000);
  EXPECT_EQ(traffic.leader(a, {1e9}).gap, 1e9);
  const int b = traffic.add(car_at(2, first, 4, 3));
  EXPECT_EQ(traffic.leader(a, {}).car, b);
  EXPECT_DOUBLE_EQ(traffic.leader(a, {}).gap, 94 - 5);
  EXPECT_EQ(traffic.links_under(b), (std::vector<std::int32_t>{first, second}));
  EXPECT_EQ(free_path(network, {first, 10}, 260),
            (std::vector<std::int32_t>{first, second, first, second, first, second}));
  EXPECT_THROW(free_path(network, {first, 10}, 1e9), Error);
  EXPECT_THROW(free_path(network, {first, 10}, nan), Error);
}

TEST(FreePath, FollowsARouteAndEndsWhereItChanges) {
  NetworkMaker maker;
  const int lane = maker.lane(10), straight = maker.lane(10), left = maker.lane(10);
  const int on = maker.movement(lane, straight, 5), turn = maker.movement(lane, left, 5);
  maker.beside(left, {straight, false, true, false, 0, 10, 0, 10});
  const TrafficNetwork network = maker.network();
  using Links = std::vector<std::int32_t>;
  EXPECT_EQ(free_path(network, {lane, 0}, 100), (Links{lane, on, straight}));
  EXPECT_EQ(free_path(network, {lane, 0}, 10), (Links{lane}));
  EXPECT_EQ(free_path(network, {lane, 0}, 100, {lane, turn, left}), (Links{lane, turn, left}));
  EXPECT_EQ(free_path(network, {lane, 0}, 100, {turn, left}), (Links{lane, on, straight}));
  EXPECT_EQ(free_path(network, {lane, 0}, 100, {lane, turn, left, straight}),
            (Links{lane, turn, left}));
  EXPECT_NO_THROW(check_route(network, {lane, turn, left, straight}));
  try {
    check_route(network, {lane, turn, straight});
    FAIL() << "a gap";
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("link 20"), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("link 50"), std::string::npos) << e.what();
  }
  EXPECT_THROW(check_route(network, {99}), Error);
}

}  // namespace simulation_test
}  // namespace streetgen
