// Leaders of cars on random networks, against a search that knows no order of cars.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "rounds.hpp"
#include "simulation/made_network.hpp"
#include "streetgen/traffic.hpp"

namespace streetgen {
namespace simulation_test {

// A car, and the links that it came by, nearest first.
struct Driven {
  Car car;
  std::vector<int> came_by;
};

// The leaders of cars, found by trying each car on each link of the path.
class PlainSearch {
 public:
  PlainSearch(const TrafficNetwork& network, const std::vector<Driven>& cars,
              const LeaderRules& rules)
      : network_(network), cars_(cars), rules_(rules) {}

  Leader leader(int self) const {
    const Car& car = cars_[self].car;
    double start = -car.place.metres;
    int link = car.place.link;
    for (int steps = 0;; ++steps) {
      Leader best;
      best.gap = 1e300;
      const double end = start + network_.links[link].length;
      for (int front = 1; front >= 0 && best.car < 0; --front)
        for (int i = 0; i < static_cast<int>(cars_.size()); ++i)
          if (i != self) try_car(self, i, link, start, steps == 0, front == 1, best);
      try_towards(self, link, start, steps == 0, best);
      const int next = network_.links[link].straight_on;
      double stop = 1e300;
      if (next < 0) stop = end;
      if (next >= 0 && red(next)) {
        const Link& before = network_.links[link];
        const double line = start + std::min<double>(before.stop, before.length);
        if (line >= -stop_overshoot) stop = line;
      }
      if (stop < best.gap) best = {Leader::Kind::stationary, -1, stop, stop, 0};
      if (best.gap <= rules_.horizon) return best;
      if (end >= rules_.horizon || steps > 5000)
        return {Leader::Kind::moving, -1, rules_.horizon, rules_.horizon,
                network_.links[link].speed};
      start = end;
      link = next;
    }
  }

 private:
  // Whether a movement shows red: the networks have one program of red, permitted and amber.
  bool red(int link) const {
    const auto aspects = network_.aspects.of(link);
    if (aspects.empty()) return false;
    const SignalPlan& plan = network_.plans[network_.links[link].plan];
    double second = rules_.time - plan.start_offset;
    while (second < 0) second += plan.cycle;
    while (second >= plan.cycle) second -= plan.cycle;
    return second < 9;
  }

  // Metres from the start of a link to the front of a car that stands on it; below 0: it does not.
  double front_on(const Driven& driven, int link) const {
    if (driven.car.place.link == link) return driven.car.place.metres;
    double way = driven.car.place.metres;
    for (const int behind : driven.came_by) {
      if (way >= driven.car.length) return -1;
      way += network_.links[behind].length;
      if (behind == link) return way;
    }
    return -1;
  }

  void try_car(int self, int i, int link, double start, bool own, bool with_front,
               Leader& best) const {
    const Driven& other = cars_[i];
    if ((other.car.place.link == link) != with_front) return;
    const double front = front_on(other, link);
    if (front < 0) return;
    const Car& car = cars_[self].car;
    const bool behind =
        with_front && own &&
        (front < car.place.metres || (front == car.place.metres && other.car.car_id > car.car_id));
    if (behind) return;
    const double distance = start + front, gap = distance - other.car.length;
    // The first front of a link; else the rear that is nearest.
    if (best.car >= 0) {
      const Car& so_far = cars_[best.car].car;
      const bool nearer = with_front ? std::pair{distance, -other.car.car_id} <
                                           std::pair{best.distance, -so_far.car_id}
                                     : std::tuple{gap, distance, other.car.car_id} <
                                           std::tuple{best.gap, best.distance, so_far.car_id};
      if (!nearer) return;
    }
    best = {Leader::Kind::car, i, distance, gap, other.car.speed};
  }

  void try_towards(int self, int link, double start, bool own, Leader& best) const {
    const int opposite = network_.links[link].opposite;
    if (opposite < 0) return;
    Leader nearest;
    nearest.gap = 1e300;
    for (int i = 0; i < static_cast<int>(cars_.size()); ++i) {
      const Driven& other = cars_[i];
      if (i == self) continue;
      const double front = front_on(other, opposite);
      if (front < 0) continue;
      const double length = network_.links[link].length;
      if (other.car.place.link != opposite && own) continue;
      const double there = std::max(0.0, length - front);
      if (own && there <= cars_[self].car.place.metres) continue;
      const double gap = start + there;
      const bool gone = other.car.place.link != opposite;
      const bool nearest_gone = nearest.car >= 0 && cars_[nearest.car].car.place.link != opposite;
      const auto rank = [&](double g, bool away, std::int64_t id) {
        return std::tuple{g, !away, away ? id : -id};
      };
      if (nearest.car < 0 || rank(gap, gone, other.car.car_id) <
                                 rank(nearest.gap, nearest_gone, cars_[nearest.car].car.car_id))
        nearest = {Leader::Kind::car, i, gap, gap, -other.car.speed};
    }
    if (nearest.car >= 0 && nearest.gap < best.gap) best = nearest;
  }

  const TrafficNetwork& network_;
  const std::vector<Driven>& cars_;
  const LeaderRules& rules_;
};

// Cars that enter at lanes and are driven about at random, with all links that they came by.
std::vector<Driven> random_cars(std::mt19937_64& random, const NetworkMaker& maker, int count,
                                Traffic& traffic) {
  const auto below = [&](int n) { return static_cast<int>(random() % n); };
  const auto share = [&] { return below(1000) / 1000.0; };
  const TrafficNetwork& network = traffic.network();
  std::vector<Driven> cars;
  for (int i = 0; i < count; ++i) {
    Driven driven;
    driven.car.car_id = 1000 - i;
    driven.car.length = 3 + below(16);
    driven.car.speed = below(15);
    int link = below(network.size());
    // It enters where all of it has room, or nothing leads there.
    for (int tries = 0; tries < 50 && network.links[link].length < driven.car.length; ++tries)
      link = below(network.size());
    const double room = network.links[link].length - driven.car.length;
    if (room < 0) continue;
    driven.car.place = {link, driven.car.length + room * share()};
    const int index = traffic.add(driven.car);
    for (int steps = below(8); steps > 0; --steps) {
      const auto& next = maker.next(driven.car.place.link);
      if (next.empty()) break;
      const int to = next[below(static_cast<int>(next.size()))];
      const auto& came_by = driven.came_by;
      if (to == driven.car.place.link ||
          std::find(came_by.begin(), came_by.end(), to) != came_by.end())
        break;
      driven.came_by.insert(driven.came_by.begin(), driven.car.place.link);
      driven.car.place = {to, network.links[to].length * share()};
      traffic.move(index, driven.car.place);
    }
    cars.push_back(driven);
  }
  return cars;
}

void expect_same(const Leader& found, const Leader& plain, const std::string& where) {
  EXPECT_EQ(found.kind, plain.kind) << where;
  EXPECT_EQ(found.car, plain.car) << where;
  EXPECT_NEAR(found.distance, plain.distance, 1e-6) << where;
  EXPECT_NEAR(found.gap, plain.gap, 1e-6) << where;
  EXPECT_EQ(found.speed, plain.speed) << where;
}

TEST(Leaders, AreThoseOfAPlainSearch) {
  std::mt19937_64 random(1);
  int cars_led = 0, bodies_led = 0, towards = 0, stopped = 0;
  for (int round = 0; round < rounds(200); ++round) {
    const NetworkMaker maker = random_network(random, 10 + static_cast<int>(random() % 40));
    const TrafficNetwork network = maker.network();
    Traffic traffic(network);
    const std::vector<Driven> cars =
        random_cars(random, maker, 5 + static_cast<int>(random() % 60), traffic);
    LeaderRules rules;
    rules.horizon = round % 2 ? 1000 : 60;
    rules.time = 3.0 * round;
    rules.amber_deceleration = 0;  // amber stops who stands, and nobody stands
    std::vector<Driven> moving = cars;
    for (std::size_t i = 0; i < moving.size(); ++i) {
      moving[i].car.speed += 1;
      traffic.set_speed(static_cast<int>(i), moving[i].car.speed);
    }
    const std::vector<Leader> found = traffic.leaders(rules);
    const PlainSearch plain(network, moving, rules);
    for (int i = 0; i < static_cast<int>(moving.size()); ++i) {
      const Leader expected = plain.leader(i);
      expect_same(found[i], expected,
                  "round " + std::to_string(round) + ", car " + std::to_string(i));
      stopped += expected.kind == Leader::Kind::stationary;
      if (expected.car < 0) continue;
      ++cars_led;
      towards += expected.speed < 0;
      bodies_led += expected.speed >= 0 && !moving[expected.car].came_by.empty();
    }
  }
  EXPECT_GT(cars_led, rounds(200));
  EXPECT_GT(bodies_led, rounds(200) / 10);
  EXPECT_GT(towards, rounds(200) / 10);
  EXPECT_GT(stopped, rounds(200));
}

// The same cars by their keys, added in another order or moved to and fro.
TEST(Leaders, DoNotHangOnTheOrderInWhichCarsCome) {
  std::mt19937_64 random(2);
  for (int round = 0; round < rounds(100); ++round) {
    const NetworkMaker maker = random_network(random, 20);
    const TrafficNetwork network = maker.network();
    std::vector<Car> cars;
    for (int i = 0; i < 40; ++i) {
      Car car;
      car.car_id = i;
      car.place.link = static_cast<int>(random() % network.size());
      // Halves of a link, so that some stand at one place.
      car.place.metres =
          network.links[car.place.link].length * static_cast<double>(random() % 3) / 2;
      car.length = 2 + static_cast<float>(random() % 12);
      cars.push_back(car);
    }
    Traffic forward(network), backward(network);
    for (const Car& car : cars) forward.add(car);
    for (int i = 0; i < 40; ++i) {
      Car elsewhere = cars[39 - i];
      elsewhere.place = {0, 0};
      const int index = backward.add(elsewhere);
      if (i % 3 == 0) {
        backward.remove(index);
        EXPECT_EQ(backward.add(elsewhere), index);
      }
    }
    for (int i = 0; i < 40; ++i) {
      // Not along its path, so that it stands as if it were added.
      backward.remove(i);
      EXPECT_EQ(backward.add(cars[39 - i]), i);
    }
    LeaderRules rules;
    rules.merging = static_cast<MergingLeader>(round % 3);
    for (int i = 0; i < 40; ++i) {
      Leader one = forward.leader(i, rules), other = backward.leader(39 - i, rules);
      if (other.car >= 0) other.car = 39 - other.car;
      expect_same(one, other, "round " + std::to_string(round));
    }
  }
}

// The same network with its links in another order.
TrafficNetwork renumbered(const TrafficNetwork& network, const std::vector<int>& order) {
  std::vector<int> now(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) now[order[i]] = static_cast<int>(i);
  const auto renumber = [&](std::int32_t& link) { link = link < 0 ? -1 : now[link]; };
  TrafficNetwork made;
  made.plans = network.plans;
  for (const int i : order) {
    made.links.push_back(network.links[i]);
    renumber(made.links.back().straight_on);
    renumber(made.links.back().opposite);
    for (const std::int32_t next : network.next.of(i)) made.next.add(now[next]);
    for (const std::int32_t before : network.before.of(i)) made.before.add(now[before]);
    for (const SignalAspect& aspect : network.aspects.of(i)) made.aspects.add(aspect);
    made.next.end_owner();
    made.before.end_owner();
    made.aspects.end_owner();
  }
  return made;
}

TEST(Leaders, DoNotHangOnTheNumbersOfLinks) {
  std::mt19937_64 random(4);
  for (int round = 0; round < rounds(100); ++round) {
    const NetworkMaker maker = random_network(random, 30);
    const TrafficNetwork network = maker.network();
    std::vector<int> order(network.size()), now(network.size());
    for (int i = 0; i < network.size(); ++i) order[i] = i;
    std::shuffle(order.begin(), order.end(), random);
    for (int i = 0; i < network.size(); ++i) now[order[i]] = i;
    const TrafficNetwork other_network = renumbered(network, order);
    Traffic traffic(network), other(other_network);
    for (const Driven& driven : random_cars(random, maker, 40, traffic)) {
      Car car = driven.car;
      const auto& came_by = driven.came_by;
      car.place = {now[came_by.empty() ? car.place.link : came_by.back()], 0};
      car.place.metres = other_network.links[car.place.link].length;
      const int index = other.add(car);
      for (int i = static_cast<int>(came_by.size()) - 2; i >= 0; --i)
        other.move(index, {now[came_by[i]], 0});
      other.move(index, {now[driven.car.place.link], driven.car.place.metres});
    }
    LeaderRules rules;
    rules.merging = static_cast<MergingLeader>(round % 3);
    rules.time = round;
    for (int i = 0; i < traffic.size(); ++i)
      expect_same(traffic.leader(i, rules), other.leader(i, rules),
                  "round " + std::to_string(round) + ", car " + std::to_string(i));
  }
}

TEST(Leaders, HaveNobodyBetweenAndDistancesThatAddUp) {
  std::mt19937_64 random(3);
  for (int round = 0; round < rounds(100); ++round) {
    NetworkMaker maker;
    // A chain of lanes and movements.
    int last = maker.lane(20 + static_cast<double>(random() % 50));
    std::vector<double> starts{0};
    std::vector<int> links{last};
    for (int i = 0; i < 10; ++i) {
      const int lane = maker.lane(1 + static_cast<double>(random() % 30));
      const int movement = maker.movement(last, lane, 1 + static_cast<double>(random() % 9));
      for (const int link : {movement, lane}) {
        starts.push_back(starts.back() + maker.link(links.back()).length);
        links.push_back(link);
      }
      last = lane;
    }
    const TrafficNetwork network = maker.network();
    Traffic traffic(network);
    std::map<double, int> by_place;
    const double end = starts.back() + network.links[last].length;
    for (double place = 6; place < end; place += 5.5 + static_cast<double>(random() % 40)) {
      std::size_t i = links.size() - 1;
      while (starts[i] > place) --i;
      Car car;
      car.car_id = static_cast<std::int64_t>(place * 2);
      car.place = {links[i], place - starts[i]};
      by_place[place] = traffic.add(car);
    }
    LeaderRules rules;
    rules.horizon = 5000;
    for (auto at = by_place.begin(); at != by_place.end(); ++at) {
      const Leader leader = traffic.leader(at->second, rules);
      const auto ahead = std::next(at);
      if (ahead == by_place.end()) {
        EXPECT_EQ(leader.kind, Leader::Kind::stationary);
        EXPECT_NEAR(leader.gap, end - at->first, 1e-6);
        continue;
      }
      EXPECT_EQ(leader.car, ahead->second);
      EXPECT_NEAR(leader.distance, ahead->first - at->first, 1e-6);
      EXPECT_NEAR(leader.gap, ahead->first - at->first - 5, 1e-6);
      EXPECT_EQ(traffic.free_distance(at->second, rules), leader.gap);
    }
  }
}

}  // namespace simulation_test
}  // namespace streetgen
