#include "simulation/change_lanes.hpp"

#include <algorithm>
#include <cmath>

#include "simulation/driver_sight.hpp"
#include "simulation/event_obeyed.hpp"
#include "simulation/follower.hpp"

namespace streetgen {

namespace {

constexpr double follower_reach = 80;  // metres back from where a car changes to
constexpr double least_room = 0.5;     // metres to who is ahead and behind

double acceleration_behind(const CarRun& run, const Driver& follower, double gap,
                           const Driver& leader) {
  Sight sight;
  sight.desired_speed = run.link(follower.at.link).speed;
  sight.gap = std::max(0., gap);
  sight.leader_speed = leader.speed;
  sight.leader_acceleration = leader.acceleration;
  return acceleration_of(run, follower, sight);
}

double acceleration_alone(const CarRun& run, const Driver& driver, int car, int ahead) {
  Sight sight;
  look_ahead(run, driver, car, ahead, sight);
  return acceleration_of(run, driver, sight);
}

// A lane beside, and where the car would be there.
struct Target {
  WayPlace at;
  double metres = 0;
  bool must = false, right = false;
};

class LaneChoice {
 public:
  LaneChoice(CarRun& run, int car) : run_(run), car_(car), driver_(run.drivers[car]) {}

  void look() {
    if (driver_.let_in > driver_.at.passed || run_.link(driver_.at.link).movement ||
        driver_.metres < driver_.length)
      return;
    Target best;
    double gain = -no_end;
    for (const LinkBeside& b : run_.network->beside.of(driver_.at.link)) {
      if (!b.may_change || b.opposite || driver_.metres < b.from || driver_.metres > b.to) continue;
      if ((run_.link(b.link).traffic & driver_.kind) == 0) continue;
      Target target;
      if (!wished(b, target)) continue;
      const double gained = gain_of(target);
      if (gained > (target.must ? -1e3 : run_.rules.lanes.threshold) && gained > gain) {
        gain = gained;
        best = target;
      }
    }
    if (best.at.link >= 0) change(best);
  }

 private:
  // Whether a change leads on, or is allowed by the way to be driven.
  bool wished(const LinkBeside& b, Target& target) const {
    const double share = b.to > b.from ? (driver_.metres - b.from) / (b.to - b.from) : 0;
    target.metres = std::clamp(b.other_from + share * (b.other_to - b.other_from), 0.,
                               run_.link(b.link).length);
    target.at = {b.link, driver_.at.passed, -1};
    target.right = !b.left;
    if (target.metres < driver_.length) return false;
    WayPlace ahead = driver_.at;
    const bool blocked = go_on(run_, driver_, ahead) == must_change;
    target.must = !blocked && b.left != run_.network->left_hand && overtakes(run_, driver_);
    if (driver_.route < 0) {
      const bool here = run_.leads_out[driver_.at.link], there = run_.leads_out[b.link];
      target.must = target.must || blocked || (there && !here);
      return (there || !here) && (!run_.merges[b.link] || run_.merges[driver_.at.link]);
    }
    const auto& route = run_.cars.routes[driver_.route];
    if (driver_.at.on_route < 0) {
      const auto place = std::find(route.begin(), route.end(), b.link);
      if (place == route.end()) return false;
      target.must = true;
      target.at.on_route = static_cast<std::int32_t>(place - route.begin());
      return true;
    }
    if (blocked) {
      target.must = true;
      target.at.on_route = driver_.at.on_route + 1;
      return route[target.at.on_route] == b.link;
    }
    return run_.link(driver_.at.link).length - driver_.metres > run_.rules.lanes.change_back;
  }

  // What the change gains, by MOBIL; minus infinity where it is not safe.
  double gain_of(const Target& target) const {
    const LaneChangeRules& rules = run_.rules.lanes;
    const int link = target.at.link;
    if (run_.occupied[link] + run_.reserved[link] + run_.room_of(driver_) > run_.link(link).length)
      return -no_end;
    const int opposite = run_.link(link).opposite;
    if (opposite >= 0 || run_.link(driver_.at.link).opposite >= 0) return -no_end;
    if (!run_.claims[link].empty()) return -no_end;  // who passes it could not wait there
    Driver there = driver_;
    there.at = target.at;
    there.metres = target.metres;
    const int ahead = run_.cars.first_from(link, target.metres);
    if (ahead >= 0) {
      const Driver& leader = run_.drivers[ahead];
      if (leader.metres - leader.length - target.metres < least_room) return -no_end;
    }
    Sight sight;
    look_ahead(run_, there, car_, ahead, sight);
    if (sight.free < least_room && !target.must) return -no_end;
    const Follower behind = follower_of(run_, link, target.metres, driver_.length, follower_reach);
    if (behind.car == car_ || behind.gap < least_room) return -no_end;
    const double own = acceleration_of(run_, there, sight);
    if (own < -rules.safe_braking && driver_.speed > 1) return -no_end;
    double others = 0;
    if (behind.car >= 0) {
      const Driver& follower = run_.drivers[behind.car];
      const double after = acceleration_behind(run_, follower, behind.gap, there);
      if (after < -rules.safe_braking) return -no_end;
      others += after - follower.acceleration;
    }
    if (target.must) return own;
    if (run_.time - driver_.changed < rules.rest) return -no_end;
    const int left_behind = run_.cars.behind(car_);
    if (left_behind >= 0) {
      const Driver& follower = run_.drivers[left_behind];
      const double after = acceleration_alone(run_, follower, left_behind, run_.cars.ahead(car_));
      others += after - follower.acceleration;
    }
    const double here = acceleration_alone(run_, driver_, car_, run_.cars.ahead(car_));
    const bool to_side = target.right != run_.network->left_hand;
    return own - here + rules.politeness * others +
           (to_side ? rules.keep_to_side : -rules.keep_to_side);
  }

  void change(const Target& target) {
    Driver& driver = run_.drivers[car_];
    if (!driver.reserved.empty()) return;
    run_.occupied[driver.at.link] -= run_.room_of(driver);
    driver.at = target.at;
    driver.metres = target.metres;
    driver.asked = -1;
    driver.changed = run_.time;
    run_.occupied[driver.at.link] += run_.room_of(driver);
    ++run_.passed[driver.at.link];
    run_.cars.move(car_, {driver.at.link, driver.metres});
  }

  CarRun& run_;
  int car_;
  const Driver& driver_;
};

}  // namespace

void change_lanes(CarRun& run, double step) {
  const std::uint64_t every =
      std::max<std::uint64_t>(1, static_cast<std::uint64_t>(run.rules.lanes.interval / step + 0.5));
  for (std::size_t car = 0; car < run.drivers.size(); ++car) {
    const Driver& driver = run.drivers[car];
    if (!driver.here || (run.steps + car) % every != 0) continue;
    if (!run.network->beside.of(driver.at.link).empty())
      LaneChoice(run, static_cast<int>(car)).look();
  }
}

}  // namespace streetgen
