#include "simulation/driver_sight.hpp"

#include <algorithm>
#include <cmath>

#include "simulation/event_obeyed.hpp"
#include "simulation/signal_aspect.hpp"

namespace streetgen {

namespace {

// How far the rear of who went last from a link is behind its end; below it: before the end.  A car
// that turned off counts until it is out of the way.
constexpr double out_of_the_way = 3;
// Who is farther on a stretch did not wait before it.
constexpr double standing_on = 1e-6;

bool stops_at(const CarRun& run, const Driver& driver, int movement, double to_stop) {
  return stops_for(aspect_at(*run.network, movement, run.time), driver.speed, to_stop,
                   run.rules.amber_deceleration);
}

bool sees_last_left(const CarRun& run, int link, int itself, double to_end, Sight& sight) {
  const LastLeft& last = run.last_left[link];
  if (last.car < 0 || last.car == itself) return false;
  const Driver& other = run.drivers[last.car];
  if (!other.here || other.car_id != last.car_id) return false;
  const double behind = other.way - last.way - other.length;
  if (behind > out_of_the_way) return false;
  sight.gap = std::min(sight.gap, to_end + behind);
  sight.leader_speed = other.speed;
  sight.leader_acceleration = other.acceleration;
  return true;
}

void sees(const Driver& other, double gap, Sight& sight) {
  if (gap >= sight.gap) return;
  sight.gap = gap;
  sight.leader_speed = other.speed;
  sight.leader_acceleration = other.acceleration;
}

// A slower link ahead: as fast as comfortable braking allows.
void slow_down_for(const CarRun& run, int link, double to_start, Sight& sight) {
  const double most = run.link(link).speed;
  if (most >= sight.desired_speed) return;
  sight.desired_speed =
      std::min(sight.desired_speed,
               std::sqrt(most * most + 2 * run.rules.driver.braking * std::max(0., to_start)));
}

void see_claims(const CarRun& run, const Driver& driver, Sight& sight) {
  for (const int link : driver.claims) {
    const auto& own = run.claims[link];
    const auto mine = std::find_if(own.begin(), own.end(), [&](const GroundClaim& c) {
      return &run.drivers[c.car] == &driver;
    });
    if (mine == own.end()) continue;
    for (const LinkConflict& c : run.network->conflicts.of(link)) {
      for (const GroundClaim& other : run.claims[c.link]) {
        if (other.order > mine->order) continue;
        const Driver& first = run.drivers[other.car];
        const double left = other.start + c.other_to +
                            std::max(0., first.length - run.rules.car_length) - first.way;
        if (left <= 0) continue;
        double wait = mine->start + c.from - driver.way;
        if (wait < -standing_on) continue;  // both were put there
        wait = std::max(0., wait);
        sight.claims.push_back({wait, wait - left, first.speed});
        sight.free = std::min(sight.free, wait);
      }
    }
  }
}

}  // namespace

double seconds_for(double metres, double speed, double most) {
  if (metres <= 0) return 0;
  constexpr double acceleration = 1;
  most = std::max(most, speed);
  const double to_most = (most * most - speed * speed) / (2 * acceleration);
  if (metres >= to_most) return (most - speed) / acceleration + (metres - to_most) / most;
  return (std::sqrt(speed * speed + 2 * acceleration * metres) - speed) / acceleration;
}

void look_ahead(const CarRun& run, const Driver& driver, int itself, int ahead, Sight& sight) {
  WayPlace at = driver.at;
  double to_start = -driver.metres;
  const double comfortable =
      driver.speed * driver.speed / (2 * run.rules.driver.braking) + driver.speed;
  sight.desired_speed = run.link(at.link).speed;
  if (!driver.claims.empty()) see_claims(run, driver, sight);
  double walker = no_end;  // metres to somebody who crosses
  while (to_start < run.rules.horizon) {
    const Link& link = run.link(at.link);
    const double to_end = to_start + link.length, to_stop = to_start + link.stop;
    const int other =
        at.link == driver.at.link && to_start <= 0 ? ahead : run.cars.rearmost(at.link);
    if (other == itself) break;  // the way is a ring
    walker = std::min(walker, to_walker(run, driver, at.link, to_start));
    bool blocked = false;
    if (other >= 0) {
      const Driver& leader = run.drivers[other];
      sees(leader, to_start + leader.metres - leader.length, sight);
      blocked = true;
      // Who follows one that was let in may ask, too.
      if (leader.let_in <= leader.at.passed) {
        if (driver.let_in > at.passed && leader.at.link == driver.at.link) sight.revoked = true;
        break;
      }
    } else if (sees_last_left(run, at.link, itself, to_end, sight)) {
      blocked = true;
    }
    WayPlace next = at;
    const int to = go_on(run, driver, next);
    if (to == way_ends) break;
    if (to == must_change) {
      sight.stop = std::max(0., to_stop);
      break;
    }
    if (run.guarded[to]) {
      const bool let_in = driver.let_in >= next.passed;
      const bool on_lane = at.link == driver.at.link;
      const bool red = stops_at(run, driver, to, std::max(0., to_stop));
      if (let_in && on_lane && red && to_stop > 0 &&
          driver.speed * driver.speed <= 2 * run.rules.amber_deceleration * to_stop)
        sight.revoked = true;
      if (!let_in) {
        // Beyond the stop place a car that was not let in stands still.
        const double wait = to_stop > 0 ? to_stop : std::max(0., to_end);
        sight.asks = wait <= comfortable + driver.speed + 10;
        sight.request = {itself, at, wait, to_end, driver.asked};
        if (red || wait <= comfortable + run.rules.driver.least_gap) sight.stop = wait;
        break;
      }
    }
    if (blocked) break;
    slow_down_for(run, to, to_end, sight);
    to_start = to_end;
    at = next;
  }
  sight.stop = std::min(sight.stop, walker);
  sight.free = std::max(0., std::min({sight.free, sight.gap, sight.stop}));
}

void ask_law(const CarRun& run, const Driver& driver, const Sight& sight,
             std::vector<Following>& rows) {
  // Who is faster than allowed brakes comfortably.
  const DriverModel& model = run.rules.driver;
  const double slowing = 1 / std::sqrt(std::sqrt(1 + model.braking / model.acceleration));
  const double desired = std::max(sight.desired_speed, driver.speed * slowing);
  rows.push_back({driver.speed, desired, sight.gap, sight.leader_speed, sight.leader_acceleration});
  if (sight.stop < no_end) rows.push_back({driver.speed, desired, sight.stop, 0, 0});
  for (const SightedClaim& claim : sight.claims) {
    rows.push_back({driver.speed, desired, claim.wait, 0, 0});
    rows.push_back({driver.speed, desired, std::max(0., claim.gap), claim.speed, 0});
  }
}

double take_answer(const CarRun& run, const Sight& sight, const double*& answers) {
  double least = *answers++;
  if (sight.stop < no_end) least = std::min(least, *answers++);
  for (std::size_t i = 0; i < sight.claims.size(); ++i, answers += 2)
    least = std::min(least, std::max(answers[0], answers[1]));
  return std::max(least, -run.rules.hardest_braking);
}

void answer(const CarRun& run, const std::vector<Following>& rows, std::vector<double>& answers) {
  answers.resize(rows.size());
  if (run.rules.law) return run.rules.law(rows, answers);
  for (std::size_t i = 0; i < rows.size(); ++i)
    answers[i] = idm_acceleration(run.rules.driver, rows[i]);
}

double acceleration_of(const CarRun& run, const Driver& driver, const Sight& sight) {
  std::vector<Following> rows;
  std::vector<double> answers;
  ask_law(run, driver, sight, rows);
  answer(run, rows, answers);
  const double* first = answers.data();
  return take_answer(run, sight, first);
}

}  // namespace streetgen
