#include "streetgen/car_following.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "simulation/change_lanes.hpp"
#include "simulation/demand.hpp"
#include "simulation/driver.hpp"
#include "simulation/driver_sight.hpp"
#include "simulation/enter_cars.hpp"
#include "simulation/event_obeyed.hpp"
#include "simulation/event_passing.hpp"
#include "simulation/let_in_cars.hpp"
#include "simulation/link_end.hpp"
#include "simulation/traffic_events.hpp"
#include "streetgen/error.hpp"

namespace streetgen {

namespace {

[[noreturn]] void refuse_driving(const std::string& message) {
  throw Error(ErrorKind::invalid_input, message);
}

void require_driving(const char* name, double value) {
  if (!std::isfinite(value) || value <= 0)
    refuse_driving(std::string("rule ") + name + " of drivers is " + text_of(value) +
                   ", not above 0");
}

void check_rules(const DrivingRules& rules) {
  require_driving("acceleration", rules.driver.acceleration);
  require_driving("braking", rules.driver.braking);
  require_driving("time_gap", rules.driver.time_gap);
  require_driving("least_gap", rules.driver.least_gap);
  require_driving("safe_braking", rules.lanes.safe_braking);
  require_driving("interval", rules.lanes.interval);
  require_driving("horizon", rules.horizon);
  require_driving("hardest_braking", rules.hardest_braking);
  require_driving("amber_deceleration", rules.amber_deceleration);
  require_driving("patience", rules.patience);
  require_driving("car_length", rules.car_length);
  require_driving("car_width", rules.car_width);
  if (rules.horizon > farthest_horizon)
    refuse_driving("rule horizon of drivers is " + text_of(rules.horizon) + ", beyond " +
                   text_of(farthest_horizon));
}

void read_links(CarRun& run) {
  const TrafficNetwork& network = *run.network;
  const int size = network.size();
  run.guarded.assign(size, 0);
  run.crossed.assign(size, 0);
  run.merges.assign(size, 0);
  run.clear_at.assign(size, 0);
  run.claims.resize(size);
  run.arrivals.resize(size);
  run.occupied.assign(size, 0);
  run.reserved.assign(size, 0);
  run.last_left.resize(size);
  run.passed.assign(size, 0);
  run.share = turn_shares(network, {});
  run.leads_out = links_that_lead_out(network);
  for (int i = 0; i < size; ++i) {
    const Link& link = network.links[i];
    if (!(link.length > 0) || !(link.speed > 0) || !std::isfinite(link.length) ||
        !std::isfinite(link.speed))
      refuse_driving("link " + std::to_string(link.link_id) + " has length " +
                     text_of(link.length) + " and speed " + text_of(link.speed));
    run.merges[i] = merges_beside(network, i);
    run.crossed[i] = !network.conflicts.of(i).empty();
    run.guarded[i] = run.crossed[i] || !network.aspects.of(i).empty();
    for (const int next : network.next.of(i))
      run.guarded[i] |= link.movement && network.links[next].opposite >= 0;
    for (const LinkConflict& c : network.conflicts.of(i))
      run.clear_at[i] = std::max(run.clear_at[i], c.to);
    if (link.opposite >= 0)
      run.clear_at[i] = static_cast<float>(link.length + run.rules.car_length);
  }
}

// Goes on by metres, onto the links of its way; the car leaves at the end.
void drive(CarRun& run, int car, double metres) {
  Driver& driver = run.drivers[car];
  note_passing(run, car, driver.at.link, driver.metres, driver.metres + metres);
  driver.metres += metres;
  driver.way += metres;
  double length = run.link(driver.at.link).length;
  while (driver.metres > length) {
    WayPlace next = driver.at;
    const int to = go_on(run, driver, next);
    if (to == way_ends) {
      ++run.left;
      return take_car(run, car);
    }
    double most = to == must_change || (run.guarded[to] && driver.let_in < next.passed)
                      ? 0
                      : driver.metres - length;
    if (most > 0) {
      const int other = run.cars.rearmost(to);
      if (other >= 0 && other != car)
        most = std::min(most, run.drivers[other].metres - run.drivers[other].length);
    }
    if (most <= 0) {  // nobody else was seen to come there, too
      driver.way -= driver.metres - length;
      driver.metres = length;
      driver.speed = 0;
      break;
    }
    driver.way -= driver.metres - length - most;
    run.last_left[driver.at.link] = {car, driver.car_id, driver.way - most};
    run.occupied[driver.at.link] -= run.room_of(driver);
    driver.at = next;
    driver.metres = most;
    note_passing(run, car, to, before_start, most);
    occupy(run, driver);
    length = run.link(to).length;
    run.cars.move(car, {to, std::min(driver.metres, length)});
  }
  run.cars.move(car, {driver.at.link, driver.metres});
  run.cars.set_speed(car, driver.speed);
  if (!driver.claims.empty()) give_up_claims(run, car);
}

// Others give way to who comes, unless it may not or has no room behind.
void see_arrival(CarRun& run, const LetInRequest& request, const Driver& driver) {
  if (driver.no_room && driver.speed < 0.5) return;
  WayPlace next = request.before;
  const int movement = go_on(run, driver, next);
  const Aspect aspect = aspect_at(*run.network, movement, run.time);
  if (aspect == Aspect::red || aspect == Aspect::amber) return;
  const double seconds =
      seconds_for(request.to_end, driver.speed, run.link(request.before.link).speed);
  const auto arrives = [&](int link) {
    Arrival& arrival = run.arrivals[link];
    if (arrival.step == run.steps && arrival.seconds <= seconds) return;
    arrival = {run.steps, seconds, driver.asked >= 0 && driver.speed < 0.5, request.car};
  };
  arrives(movement);
  const int lane = go_on(run, driver, next);
  if (lane >= 0 && run.link(lane).opposite >= 0) arrives(lane);
}

}  // namespace

CarFollowing::CarFollowing(const TrafficNetwork& network, const DrivingRules& rules,
                           std::uint64_t seed) {
  check_rules(rules);
  run_ = std::make_unique<CarRun>(network, rules, seed);
  read_links(*run_);
}

CarFollowing::~CarFollowing() = default;
CarFollowing::CarFollowing(CarFollowing&&) noexcept = default;
CarFollowing& CarFollowing::operator=(CarFollowing&&) noexcept = default;

void CarFollowing::set_routes(const std::vector<std::vector<std::int32_t>>& routes) {
  for (const auto& route : routes) check_route(*run_->network, route);
  run_->cars.routes = routes;
}

void CarFollowing::set_entries(const std::vector<TrafficEntry>& entries) {
  check_entries(*run_->network, entries);
  for (const TrafficEntry& e : entries) {
    if (e.route < 0) continue;
    if (e.route >= static_cast<int>(run_->cars.routes.size()))
      refuse_driving("an entry follows route " + std::to_string(e.route) + " of " +
                     std::to_string(run_->cars.routes.size()));
    const auto& route = run_->cars.routes[e.route];
    if (route.empty() || route[0] != e.link)
      refuse_driving("an entry into link " + std::to_string(run_->link(e.link).link_id) +
                     " follows a route that begins elsewhere");
  }
  run_->entries.clear();
  for (const TrafficEntry& e : entries) {
    CarRun::Entry entry;
    entry.entry = e;
    if (e.flow > 0)
      entry.next = run_->time +
                   drawn(run_->seed, ~static_cast<std::uint64_t>(run_->entries.size()), 0) / e.flow;
    run_->entries.push_back(entry);
  }
}

void CarFollowing::set_turns(const std::vector<TurnShare>& turns) {
  run_->share = turn_shares(*run_->network, turns);
}

void CarFollowing::set_events(const std::vector<TrafficEvent>& events) {
  check_events(*run_, events);
  read_events(*run_, events);
}

const std::vector<FiredEvent>& CarFollowing::fired() const { return run_->fired; }

int CarFollowing::add(const Car& car) {
  if (!(car.speed >= 0))
    refuse_driving("car " + std::to_string(car.car_id) + " drives at " + text_of(car.speed));
  const int index = put_car(*run_, car);
  run_->next_car_id = std::max(run_->next_car_id, car.car_id + 1);
  for (const int other : {run_->cars.ahead(index), run_->cars.behind(index)}) {
    if (other < 0) continue;
    const Driver &a = run_->drivers[index], &b = run_->drivers[other];
    const Driver &first = a.metres >= b.metres ? a : b, &second = &first == &a ? b : a;
    if (first.metres - first.length >= second.metres) continue;
    const std::string message = "cars " + std::to_string(a.car_id) + " and " +
                                std::to_string(b.car_id) + " stand on each other at " +
                                text_of(car.place.metres) + " metres of link " +
                                std::to_string(run_->link(car.place.link).link_id);
    take_car(*run_, index);
    refuse_driving(message);
  }
  return index;
}

void CarFollowing::step(double seconds) {
  CarRun& run = *run_;
  if (!(seconds > 0 && seconds <= 1))
    refuse_driving("step " + text_of(seconds) + " s is not above 0 and at most 1 s");
  ++run.steps;
  enter_cars(run, seconds);
  fire_events(run);
  run.requests.clear();
  std::vector<Sight>& sights = run.sights;
  sights.resize(run.drivers.size());
  run.rows.clear();
  for (std::size_t i = 0; i < run.drivers.size(); ++i) {
    if (!run.drivers[i].here) continue;
    const int car = static_cast<int>(i);
    sights[i] = Sight();
    look_ahead(run, run.drivers[i], car, run.cars.ahead(car), sights[i]);
    sights[i].desired_speed += faster_by(run, run.drivers[i]);
    if (sights[i].request.car >= 0) see_arrival(run, sights[i].request, run.drivers[i]);
    if (sights[i].asks) run.requests.push_back(sights[i].request);
    ask_law(run, run.drivers[i], sights[i], run.rows);
  }
  answer(run, run.rows, run.answers);
  const double* answers = run.answers.data();
  for (std::size_t i = 0; i < run.drivers.size(); ++i) {
    Driver& driver = run.drivers[i];
    if (!driver.here) continue;
    driver.acceleration = obeyed(run, driver, take_answer(run, sights[i], answers), seconds);
    if (sights[i].revoked) take_back(run, static_cast<int>(i));
  }
  let_in_cars(run);
  for (std::size_t i = 0; i < run.drivers.size(); ++i) {
    Driver& driver = run.drivers[i];
    if (!driver.here) continue;
    const double before = driver.speed;
    driver.speed = before + driver.acceleration * seconds;
    double metres = (before + driver.speed) / 2 * seconds;
    if (driver.speed < 0) {
      metres = before * before / (-2 * driver.acceleration);
      driver.speed = 0;
    }
    if (metres > sights[i].free) {
      metres = sights[i].free;
      driver.speed = std::min(driver.speed, metres / seconds);
    }
    drive(run, static_cast<int>(i), metres);
  }
  run.time += seconds;
  change_lanes(run, seconds);
}

const Traffic& CarFollowing::traffic() const { return run_->cars; }
double CarFollowing::acceleration(int car) const { return run_->drivers.at(car).acceleration; }
double CarFollowing::time() const { return run_->time; }
std::int64_t CarFollowing::entered() const { return run_->entered; }
std::int64_t CarFollowing::left() const { return run_->left; }
std::int64_t CarFollowing::passed(int link) const { return run_->passed.at(link); }

std::int64_t CarFollowing::waiting() const {
  std::int64_t cars = 0;
  for (const CarRun::Entry& e : run_->entries) cars += e.waiting;
  return cars;
}

}  // namespace streetgen
