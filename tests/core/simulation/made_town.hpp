// Towns at random, and what must hold of all cars on a network.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

#include "made_network.hpp"
#include "streetgen/traffic.hpp"
#include "streetgen/traffic_demand.hpp"

namespace streetgen {
namespace simulation_test {

// How many of its streets are short, and how long these are; the cycle of its signals; cars a
// second by each street from outside.
struct TownStyle {
  double short_share = 0.3, shortest = 0.5, longest_short = 9;
  float cycle = 50;
  double least_flow = 0.03, most_flow = 0.15;
};

// A town of streets that cross, with signals, lanes for both directions, lanes beside each other
// and links shorter than a car.
struct Town {
  TrafficNetwork network;
  std::vector<TrafficEntry> entries;
  std::vector<TurnShare> turns;
};

class TownMaker {
 public:
  TownMaker(std::uint64_t seed, int width, int height, const TownStyle& style = {})
      : random_(seed), width_(width), height_(height), style_(style) {}

  Town made() {
    arriving_.resize(nodes());
    leaving_.resize(nodes());
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) {
        street(at(x, y), x + 1 < width_ ? at(x + 1, y) : -1);
        street(at(x, y), y + 1 < height_ ? at(x, y + 1) : -1);
        if (x == 0 || y == 0) street(at(x, y), -1);
      }
    for (int node = 0; node < nodes(); ++node) junction(node);
    town_.network = maker_.network();
    return town_;
  }

 private:
  int nodes() const { return width_ * height_; }
  int at(int x, int y) const { return y * width_ + x; }
  double any(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() % 10000) / 10000;
  }
  bool chance(double p) { return any(0, 1) < p; }

  // To a node, or out of the town.
  void street(int from, int to) {
    const double length = to < 0                       ? any(60, 150)
                          : chance(style_.short_share) ? any(style_.shortest, style_.longest_short)
                                                       : any(20, 160);
    const float speed = static_cast<float>(any(8, 16));
    const auto lane = [&](int a, int b) {
      const int made = maker_.lane(length, speed);
      maker_.link(made).stop = static_cast<float>(length * (chance(0.5) ? 1 : 0.9));
      if (a >= 0) leaving_[a].push_back(made);
      if (b >= 0) arriving_[b].push_back(made);
      if (a < 0) town_.entries.push_back({made, any(style_.least_flow, style_.most_flow), -1});
      return made;
    };
    const int there = lane(from, to), back = lane(to, from);
    if (to >= 0 && length > 20 && chance(0.15)) {
      maker_.opposite(there, back);
    } else if (length > 60 && chance(0.4)) {
      const int second = lane(from, to);
      maker_.lanes_beside(second, there, 0, static_cast<float>(length));
    }
  }

  void junction(int node) {
    struct Way {
      int link, from, to, rank;
      double length;
    };
    std::vector<Way> ways;
    for (const int from : arriving_[node])
      for (const int to : leaving_[node]) {
        if (maker_.link(from).opposite == to && from != to) continue;
        if (arriving_[node].size() > 2 && chance(0.2)) continue;
        const double length = any(4, 25);
        const int link = maker_.movement(from, to, length, static_cast<float>(any(6, 13)));
        ways.push_back({link, from, to, static_cast<int>(random_() % 4), length});
        town_.turns.push_back({from, link, any(0.1, 1)});
      }
    const bool signals = chance(0.4);
    for (Way& way : ways)
      if (signals) {
        const float half = style_.cycle / 2, from = way.from % 2 == 0 ? 0 : half;
        maker_.green(way.link, style_.cycle, from, from + half - 5, from + half - 2);
      }
    for (std::size_t i = 0; i < ways.size(); ++i)
      for (std::size_t k = i + 1; k < ways.size(); ++k) {
        const Way &a = ways[i], &b = ways[k];
        if (a.from == b.from) continue;
        const bool merge = a.to == b.to;
        if (!merge && chance(0.3)) continue;
        const auto stretch = [&](const Way& w) {
          const double from = any(0, w.length * 0.8);
          return std::pair<float, float>(
              from, merge ? w.length : std::min(from + any(6, 12), w.length + 5));
        };
        const auto first = stretch(a), second = stretch(b);
        if (a.rank == b.rank)
          maker_.conflict(a.link, first.first, first.second, b.link, second.first, second.second,
                          Precedence::by_arrival);
        else if (a.rank < b.rank)
          maker_.conflict(a.link, first.first, first.second, b.link, second.first, second.second);
        else
          maker_.conflict(b.link, second.first, second.second, a.link, first.first, first.second);
      }
  }

  std::mt19937_64 random_;
  int width_, height_;
  TownStyle style_;
  NetworkMaker maker_;
  Town town_;
  std::vector<std::vector<int>> arriving_, leaving_;
};

// A car whose front is so far along a link, or beyond it.
struct Standing {
  int car;
  double front;
};

// The cars on each link.
inline std::vector<std::vector<Standing>> standing_on(const Traffic& traffic) {
  std::vector<std::vector<Standing>> found(traffic.network().size());
  for (int car = 0; car < traffic.size(); ++car) {
    if (!traffic.holds(car)) continue;
    double front = traffic.car(car).place.metres;
    bool first = true;
    for (const int link : traffic.links_under(car)) {
      if (!first) front += traffic.network().links[link].length;
      first = false;
      found[link].push_back({car, front});
    }
  }
  return found;
}

// Cars of one link, those on ground that two movements need, and those on a lane for both
// directions.
inline void expect_nobody_meets(const Traffic& traffic, double time) {
  const TrafficNetwork& network = traffic.network();
  for (int link = 0; link < network.size(); ++link)
    for (int car = traffic.foremost(link); car >= 0; car = traffic.behind(car)) {
      const int next = traffic.behind(car);
      if (next < 0) break;
      const Car first = traffic.car(car), second = traffic.car(next);
      ASSERT_GE(first.place.metres - first.length, second.place.metres - 1e-9)
          << "link " << link << " cars " << first.car_id << " " << second.car_id << " at " << time;
    }
  const auto standing = standing_on(traffic);
  for (int link = 0; link < network.size(); ++link) {
    for (const LinkConflict& c : network.conflicts.of(link)) {
      if (c.link < link) continue;
      for (const Standing& a : standing[link])
        for (const Standing& b : standing[c.link]) {
          const bool meet = a.car != b.car && a.front > c.from + 1e-6 && a.front < c.to - 1e-6 &&
                            b.front > c.other_from + 1e-6 && b.front < c.other_to - 1e-6;
          ASSERT_FALSE(meet) << "movements " << link << " and " << c.link << " at " << time
                             << ": cars " << traffic.car(a.car).car_id << " at " << a.front << ", "
                             << traffic.car(b.car).car_id << " at " << b.front;
        }
    }
    const int opposite = network.links[link].opposite;
    if (opposite <= link) continue;
    for (const Standing& a : standing[link])
      for (const Standing& b : standing[opposite])
        ASSERT_EQ(a.car, b.car) << "lane " << link << " for both directions at " << time;
  }
}

// Cars that stand on ground which others need, though their front has come to the lane behind it:
// those ahead of them take all its room.
inline void expect_room_behind_junctions(const Traffic& traffic, double time) {
  constexpr double room = 7.5, still = 0.05, creeping = 0.5;
  const TrafficNetwork& network = traffic.network();
  const auto standing = standing_on(traffic);
  for (int link = 0; link < network.size(); ++link)
    for (const LinkConflict& c : network.conflicts.of(link))
      for (const Standing& s : standing[link]) {
        const Car car = traffic.car(s.car);
        if (car.place.link == link || s.front >= c.to - creeping || car.speed > still) continue;
        int cars = 1;
        for (int ahead = traffic.ahead(s.car); ahead >= 0; ahead = traffic.ahead(ahead)) ++cars;
        ASSERT_FALSE(cars > 1 && cars * room > network.links[car.place.link].stop + creeping)
            << "car " << car.car_id << " stands on movement " << link << " at " << time << ": link "
            << car.place.link << " has " << cars << " cars";
      }
}

}  // namespace simulation_test
}  // namespace streetgen
