#include "streetgen/traffic.hpp"

#include <algorithm>
#include <cmath>

#include "simulation/path_ahead.hpp"
#include "simulation/require_place.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"

namespace streetgen {

namespace {

[[noreturn]] void refuse(std::int64_t car_id, const std::string& why) {
  throw Error(ErrorKind::invalid_input, "car " + std::to_string(car_id) + " " + why);
}

void require_link(const TrafficNetwork& network, int i, const Link& link) {
  const auto refuse_link = [&](const std::string& why) {
    throw Error(ErrorKind::invalid_input, "link " + std::to_string(link.link_id) + " " + why);
  };
  if (!(link.length > 0) || !std::isfinite(link.length))
    refuse_link("is " + text_of(link.length) + " metres long");
  const auto require = [&](std::int32_t other, const char* what) {
    if (other >= network.size() || other < 0)
      refuse_link(std::string(what) + " link " + std::to_string(other) + ", which is none of the " +
                  std::to_string(network.size()));
  };
  if (link.straight_on >= 0) require(link.straight_on, "leads to");
  if (link.opposite >= 0) require(link.opposite, "lies on");
  for (const std::int32_t next : network.next.of(i)) require(next, "leads to");
  for (const std::int32_t before : network.before.of(i)) require(before, "comes after");
}

void require_speed(std::int64_t car_id, double speed) {
  if (!std::isfinite(speed)) refuse(car_id, "drives at " + text_of(speed) + " metres a second");
}

void require_route(std::int64_t car_id, int route, std::size_t routes) {
  if (route < -1 || route >= static_cast<std::int64_t>(routes))
    refuse(car_id, "follows route " + std::to_string(route) + ", which is none of the " +
                       std::to_string(routes));
}

}  // namespace

Traffic::Traffic(const TrafficNetwork& network) : network_(&network) {
  on_links_.reserve(network.size());
  for (int i = 0; i < network.size(); ++i) {
    if (i % 1024 == 0) poll_cancel();
    const Link& link = network.links[i];
    require_link(network, i, link);
    OnLink on_link;
    on_link.length = link.length;
    on_link.stop = link.stop;
    on_link.straight_on = link.straight_on;
    on_link.has_signal = !network.aspects.of(i).empty();
    on_link.both_ways = link.opposite >= 0;
    on_links_.push_back(on_link);
  }
}

int Traffic::add(const Car& car) {
  require_place(*network_, car.car_id, car.place);
  require_speed(car.car_id, car.speed);
  require_route(car.car_id, car.route, routes.size());
  if (!(car.length > 0 && car.length <= longest_car))
    refuse(car.car_id,
           "is " + text_of(car.length) + " metres long, not between 0 and " + text_of(longest_car));
  if (!(car.width > 0) || !std::isfinite(car.width))
    refuse(car.car_id, "is " + text_of(car.width) + " metres wide");
  Standing standing{car.car_id,     car.place.metres, car.speed, car.length, car.width,
                    car.place.link, car.route,        -1,        -1,         -1,
                    car.kind,       off_route};
  find_on_route(standing);
  int index = free_car_;
  if (index < 0) {
    index = static_cast<int>(cars_.size());
    cars_.push_back(standing);
  } else {
    free_car_ = cars_[index].behind;
    cars_[index] = standing;
  }
  ++count_;
  enter(index, on_links_[standing.link].rearmost);
  came_by_.clear();
  stand(index);
  return index;
}

void Traffic::remove(int car) {
  standing(car);
  stand_up(car);
  leave(car);
  cars_[car].link = -1;
  cars_[car].behind = free_car_;
  free_car_ = car;
  --count_;
}

void Traffic::move(int car, const LinkPlace& to) {
  require_place(*network_, standing(car).car_id, to);
  Standing& moved = cars_[car];
  if (to.link == moved.link) {
    moved.metres = to.metres;
    const bool in_order = (moved.ahead < 0 || goes_before(moved.ahead, car)) &&
                          (moved.behind < 0 || goes_before(car, moved.behind));
    if (!in_order) {
      const int near = moved.ahead >= 0 ? moved.ahead : moved.behind;
      leave(car);
      enter(car, near);
    }
    if (moved.bodies < 0 && moved.metres >= moved.length) return;
    came_by_.clear();
    for (int b = moved.bodies; b >= 0; b = bodies_[b].next_of_car)
      came_by_.push_back(bodies_[b].link);
  } else {
    came_by_.clear();
    if (came_along(moved, to.link))
      for (int b = moved.bodies; b >= 0; b = bodies_[b].next_of_car)
        came_by_.push_back(bodies_[b].link);
    leave(car);
    moved.link = to.link;
    moved.metres = to.metres;
    find_on_route(moved);
    enter(car, on_links_[to.link].rearmost);
  }
  stand_up(car);
  stand(car);
}

void Traffic::set_speed(int car, double speed) {
  require_speed(standing(car).car_id, speed);
  cars_[car].speed = speed;
}

void Traffic::set_route(int car, int route) {
  require_route(standing(car).car_id, route, routes.size());
  cars_[car].route = route;
  cars_[car].on_route = off_route;
  find_on_route(cars_[car]);
}

bool Traffic::holds(int car) const { return car >= 0 && car < size() && cars_[car].link >= 0; }

Car Traffic::car(int index) const {
  const Standing& s = standing(index);
  return {s.car_id,
          {s.link, s.metres},
          s.speed,
          s.length,
          s.width,
          s.route,
          static_cast<std::uint8_t>(s.kind)};
}

int Traffic::first_from(int link, double metres) const {
  int found = -1;
  for (int car = foremost(link); car >= 0 && cars_[car].metres >= metres; car = behind(car))
    found = car;
  return found;
}

int Traffic::last_before(int link, double metres) const {
  int found = -1;
  for (int car = rearmost(link); car >= 0 && cars_[car].metres < metres; car = ahead(car))
    found = car;
  return found;
}

const Traffic::Standing& Traffic::standing(int car) const {
  if (!holds(car))
    throw Error(ErrorKind::invalid_input, "there is no car of index " + std::to_string(car));
  return cars_[car];
}

// Whether a car is nearer to the end of the link of both than another one.
bool Traffic::goes_before(int car, int other) const {
  const Standing &a = cars_[car], &b = cars_[other];
  if (a.metres != b.metres) return a.metres > b.metres;
  return a.car_id != b.car_id ? a.car_id < b.car_id : car < other;
}

// Puts a car into the order of its link, looked for from a car of the link on.
void Traffic::enter(int car, int near) {
  Standing& entered = cars_[car];
  OnLink& queue = on_links_[entered.link];
  int ahead = near, behind = near < 0 ? -1 : cars_[near].behind;
  while (ahead >= 0 && goes_before(car, ahead)) {
    behind = ahead;
    ahead = cars_[ahead].ahead;
  }
  while (behind >= 0 && goes_before(behind, car)) {
    ahead = behind;
    behind = cars_[behind].behind;
  }
  entered.ahead = ahead;
  entered.behind = behind;
  (ahead < 0 ? queue.foremost : cars_[ahead].behind) = car;
  (behind < 0 ? queue.rearmost : cars_[behind].ahead) = car;
}

void Traffic::leave(int car) {
  const Standing& left = cars_[car];
  OnLink& queue = on_links_[left.link];
  (left.ahead < 0 ? queue.foremost : cars_[left.ahead].behind) = left.behind;
  (left.behind < 0 ? queue.rearmost : cars_[left.behind].ahead) = left.ahead;
}

// Routes may change beside: a place that they no longer have is none.
PathAhead Traffic::path_of(const Standing& car) const {
  if (car.on_route == off_route) return {*network_, car.link, nullptr, -1};
  const auto& route = routes[car.route];
  const bool on_route = car.on_route < route.size() && route[car.on_route] == car.link;
  return {*network_, car.link, &route, on_route ? static_cast<int>(car.on_route) : -1};
}

// The place of its link on its route: from where it was on, else from the start.
void Traffic::find_on_route(Standing& car) const {
  const std::uint32_t was = car.on_route;
  car.on_route = off_route;
  if (car.route < 0) return;
  const auto& route = routes[car.route];
  auto from = route.begin();
  if (was != off_route && was < route.size()) from += was;
  auto found = std::find(from, route.end(), car.link);
  if (found == route.end()) found = std::find(route.begin(), from, car.link);
  const std::ptrdiff_t place = found - route.begin();
  if (place < static_cast<std::ptrdiff_t>(route.size()) && route[place] == car.link &&
      place < static_cast<std::ptrdiff_t>(off_route))
    car.on_route = static_cast<std::uint32_t>(place);
}

}  // namespace streetgen
