#include <algorithm>
#include <cmath>
#include <tuple>

#include "simulation/path_ahead.hpp"
#include "simulation/signal_aspect.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"
#include "streetgen/traffic.hpp"
#include "support/infinite.hpp"

namespace streetgen {

namespace {

void require_rules(const LeaderRules& rules) {
  if (!(rules.horizon >= 0) || !std::isfinite(rules.horizon))
    throw Error(ErrorKind::invalid_input,
                "a horizon of " + text_of(rules.horizon) + " metres is not 0 or more");
  if (!std::isfinite(rules.time))
    throw Error(ErrorKind::invalid_input, text_of(rules.time) + " seconds is no time");
}

constexpr Leader nobody{Leader::Kind::moving, -1, infinite, infinite, 0};

// The speed that is allowed `rest` metres after the start of a link of a ring without exit.
double speed_on_ring(const TrafficNetwork& network, int link, double rest) {
  double length = 0;
  int at = link;
  do {
    length += network.links[at].length;
    at = network.links[at].straight_on;
  } while (at != link);
  for (rest = std::fmod(rest, length); rest > network.links[at].length;
       at = network.links[at].straight_on)
    rest -= network.links[at].length;
  return network.links[at].speed;
}

Leader stationary(double gap) { return {Leader::Kind::stationary, -1, gap, gap, 0}; }

}  // namespace

// The nearest car in the direction of a link that begins `start` metres ahead of a car.  A front on
// the link comes before a body whose front is beyond it.
Leader Traffic::nearest_on(int car, int link, double start, bool own_link) const {
  const int front = own_link ? cars_[car].ahead : rearmost(link);
  if (front >= 0 && front != car) {
    const double distance = start + cars_[front].metres;
    return {Leader::Kind::car, front, distance, distance - cars_[front].length, cars_[front].speed};
  }
  Leader nearest = nobody;
  for (int b = on_links_[link].bodies; b >= 0; b = bodies_[b].next_on_link) {
    const int other = bodies_[b].car;
    if (other == car) continue;
    const Standing& body = cars_[other];
    const double distance = start + way_to_front(b), gap = distance - body.length;
    if (nearest.car < 0 ||
        std::tie(gap, distance, body.car_id, other) <
            std::tie(nearest.gap, nearest.distance, cars_[nearest.car].car_id, nearest.car))
      nearest = {Leader::Kind::car, other, distance, gap, body.speed};
  }
  return nearest;
}

// The same of those that come towards on the same ground: the front is what one meets, or the end
// of the link where the front has left it.
Leader Traffic::nearest_towards(int car, int link, double start, bool own_link) const {
  const int opposite = network_->links[link].opposite;
  const double length = on_links_[link].length, length_towards = on_links_[opposite].length;
  if (!own_link && on_links_[opposite].bodies >= 0) {
    int first = -1;
    for (int b = on_links_[opposite].bodies; b >= 0; b = bodies_[b].next_on_link) {
      const int other = bodies_[b].car;
      if (other != car && (first < 0 || std::tie(cars_[other].car_id, other) <
                                            std::tie(cars_[first].car_id, first)))
        first = other;
    }
    if (first >= 0) return {Leader::Kind::car, first, start, start, -cars_[first].speed};
  }
  const int front = own_link
                        ? last_before(opposite, (1 - cars_[car].metres / length) * length_towards)
                        : foremost(opposite);
  if (front < 0 || front == car) return nobody;
  const double gap = start + length * (1 - cars_[front].metres / length_towards);
  return {Leader::Kind::car, front, gap, gap, -cars_[front].speed};
}

// Whether a signal keeps a car from entering a link, before which it has `gap` metres left.
bool Traffic::stopped_by_signal(double speed, int link, double gap,
                                const LeaderRules& rules) const {
  if (!on_links_[link].has_signal || gap < -stop_overshoot) return false;
  return stops_for(aspect_at(*network_, link, rules.time), speed, std::max(gap, 0.0),
                   rules.amber_deceleration);
}

Leader Traffic::leader_on_path(int car, const LeaderRules& rules) const {
  const Standing& standing = cars_[car];
  PathAhead path = path_of(standing);
  double start = -standing.metres;
  for (bool own_link = true;; own_link = false) {
    const OnLink& link = on_links_[path.link()];
    const double end = start + link.length;
    Leader leader = nearest_on(car, path.link(), start, own_link);
    if (link.both_ways) {
      const Leader towards = nearest_towards(car, path.link(), start, own_link);
      if (towards.gap < leader.gap) leader = towards;
    }
    const int next = path.follows_route() ? path.next() : link.straight_on;
    const double stop = start + std::min<double>(link.stop, link.length);
    double way_on = next < 0 ? end : infinite;
    if (stop < leader.gap && (next < 0 ? path.must_change() && stop >= -stop_overshoot
                                       : stopped_by_signal(standing.speed, next, stop, rules)))
      way_on = stop;
    if (way_on < leader.gap) leader = stationary(way_on);
    if (leader.gap <= rules.horizon) return leader;
    if (end >= rules.horizon || path.round()) {
      if (rules.stationary_end) return stationary(rules.horizon);
      const double speed = end >= rules.horizon
                               ? network_->links[path.link()].speed
                               : speed_on_ring(*network_, path.link(), rules.horizon - start);
      return {Leader::Kind::moving, -1, rules.horizon, rules.horizon, speed};
    }
    path.go_on(next);
    start = end;
  }
}

Leader Traffic::leader(int car, const LeaderRules& rules) const {
  require_rules(rules);
  standing(car);
  Leader leader = leader_on_path(car, rules);
  if (rules.merging != MergingLeader::none) see_merging(car, rules, leader);
  return leader;
}

// Link by link, whose memory is asked for before it is needed: that of the next link, its rearmost
// car, and the foremost of its own.
std::vector<Leader> Traffic::leaders(const LeaderRules& rules) const {
  require_rules(rules);
  std::vector<Leader> leaders(cars_.size());
  const auto links = static_cast<int>(on_links_.size());
  const auto link_at = [&](int i) { return i < links ? &on_links_[i] : nullptr; };
  for (int i = 0; i < links; ++i) {
    if (i % 1024 == 0) poll_cancel();
    if (const OnLink* far = link_at(i + 24)) {
      if (far->foremost >= 0) {
        __builtin_prefetch(&cars_[far->foremost]);
        __builtin_prefetch(&leaders[far->foremost], 1);
      }
      if (far->straight_on >= 0) __builtin_prefetch(&on_links_[far->straight_on]);
    }
    if (const OnLink* near = link_at(i + 12); near && near->straight_on >= 0) {
      const OnLink& next = on_links_[near->straight_on];
      if (next.rearmost >= 0) __builtin_prefetch(&cars_[next.rearmost]);
      if (next.straight_on >= 0) __builtin_prefetch(&on_links_[next.straight_on]);
    }
    for (int car = on_links_[i].foremost; car >= 0; car = cars_[car].behind) {
      leaders[car] = leader_on_path(car, rules);
      if (rules.merging != MergingLeader::none) see_merging(car, rules, leaders[car]);
    }
  }
  return leaders;
}

double Traffic::free_distance(int car, const LeaderRules& rules) const {
  return leader(car, rules).gap;
}

}  // namespace streetgen
