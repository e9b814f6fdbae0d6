// Leaders that come from another path into the same lane.
#include <algorithm>
#include <tuple>

#include "simulation/path_ahead.hpp"
#include "streetgen/traffic.hpp"
#include "support/infinite.hpp"

namespace streetgen {

namespace {

// Seconds that a way takes at a speed.
double time_of(double way, double speed) {
  return way <= 0 ? 0 : speed > 0 ? way / speed : infinite;
}

}  // namespace

// Looks at each link of the path that others lead to, as far as both see each other and the car is
// not stopped before.
void Traffic::see_merging(int car, const LeaderRules& rules, Leader& leader) const {
  PathAhead path = path_of(cars_[car]);
  double way = -cars_[car].metres;
  for (int next = path.next(); next >= 0 && !path.round(); next = path.next()) {
    way += network_->links[path.link()].length;
    const bool stopped = leader.kind == Leader::Kind::stationary && way > leader.gap;
    if (way > rules.merging_reach || stopped) return;
    for (const std::int32_t branch : network_->before.of(next))
      if (branch != path.link()) see_on_branch(car, branch, next, way, rules, leader);
    path.go_on(next);
  }
}

// Looks at the cars that come to a link by a branch.
void Traffic::see_on_branch(int car, int branch, int meeting, double way, const LeaderRules& rules,
                            Leader& leader) const {
  struct Reached {
    int link;
    double way;  // from its end to where the paths meet
  };
  std::vector<Reached> reached{{branch, 0}};
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const auto [link, behind] = reached[i];
    if (link == cars_[car].link) continue;
    for (int other = foremost(link); other >= 0; other = cars_[other].behind) {
      const double other_way = way_by_branch(other, branch, meeting, rules);
      if (other_way <= rules.merging_reach)
        compare_merging(car, other, way, other_way, rules.merging, leader);
    }
    const double length = network_->links[link].length;
    if (behind + length > rules.merging_reach) continue;
    for (const std::int32_t before : network_->before.of(link))
      if (std::none_of(reached.begin(), reached.end(),
                       [&](const Reached& r) { return r.link == before; }))
        reached.push_back({before, behind + length});
  }
}

// Metres from a front to a link that its path comes to by a branch; infinite: it does not, or a
// signal stops it before.
double Traffic::way_by_branch(int car, int branch, int meeting, const LeaderRules& rules) const {
  PathAhead path = path_of(cars_[car]);
  double start = -cars_[car].metres;
  while (start <= rules.merging_reach && !path.round()) {
    const Link& link = network_->links[path.link()];
    const int next = path.next();
    if (next < 0 || stopped_by_signal(cars_[car].speed, next,
                                      start + std::min<double>(link.stop, link.length), rules))
      break;
    start += link.length;
    if (path.link() == branch && next == meeting) return start;
    path.go_on(next);
  }
  return infinite;
}

void Traffic::compare_merging(int car, int other, double way, double other_way, MergingLeader rule,
                              Leader& leader) const {
  const Standing &follower = cars_[car], &merging = cars_[other];
  double distance = way - other_way, time = 0, other_time = 0;
  if (rule == MergingLeader::by_time) {
    time = time_of(way, follower.speed);
    other_time = time_of(other_way, merging.speed);
    if (other_time == infinite) return;
    distance = way - other_time * std::max(follower.speed, 0.0);
  }
  const bool first = std::tie(other_time, other_way, merging.car_id, other) <
                     std::tie(time, way, follower.car_id, car);
  if (!first || distance - merging.length >= leader.gap) return;
  leader = {Leader::Kind::car, other, distance, distance - merging.length, merging.speed};
}

}  // namespace streetgen
