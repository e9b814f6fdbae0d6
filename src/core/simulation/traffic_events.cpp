#include "simulation/traffic_events.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "simulation/enter_cars.hpp"
#include "simulation/event_passing.hpp"
#include "simulation/follower.hpp"
#include "streetgen/error.hpp"

namespace streetgen {

namespace {

constexpr double usual_reach = 500;     // metres back to the first car that comes
constexpr double beside_pulling = 0.5;  // metres free before and behind a car that pulls out

bool acts_on_a_car(EventKind kind) { return kind != EventKind::pull_out && kind != EventKind::cross; }

[[noreturn]] void refuse_event(const TrafficEvent& event, const std::string& why) {
  throw Error(ErrorKind::invalid_input, "event " + std::to_string(event.event_id) + " " + why);
}

void check_event(const TrafficNetwork& network, const DrivingRules& rules,
                 const TrafficEvent& event) {
  const LinkPlace& place = event.place;
  if (place.link < 0 || place.link >= network.size())
    refuse_event(event, "is on link " + std::to_string(place.link) + ", which is none");
  const Link& link = network.links[place.link];
  if (!(place.metres >= 0 && place.metres <= link.length))
    refuse_event(event, "is at " + text_of(place.metres) + " metres of a link of " +
                            text_of(link.length));
  for (const double number : {event.at, event.speed})
    if (!std::isfinite(number) || number < 0)
      refuse_event(event, "has the number " + text_of(number) + ", not 0 or more");
  if (!(event.deceleration > 0) || !std::isfinite(event.deceleration))
    refuse_event(event, "brakes by " + text_of(event.deceleration) + ", not above 0");
  if (!(event.duration >= 0)) refuse_event(event, "lasts " + text_of(event.duration) + " seconds");
  if (event.kind == EventKind::pull_out && (link.movement || link.opposite >= 0))
    refuse_event(event, "pulls out where no lane of one direction is");
  const double least = rules.car_length + beside_pulling;
  if (event.kind == EventKind::pull_out && place.metres < least)
    refuse_event(event, "pulls out " + text_of(place.metres) +
                            " metres after the start of its lane, expected " + text_of(least) +
                            " or more");
}

// Metres from the front of a car to a place on its way, no farther than `reach`; below 0: none.
double way_to(const CarRun& run, int car, const LinkPlace& place, double reach) {
  const Driver& driver = run.drivers[car];
  WayPlace at = driver.at;
  double start = -driver.metres;
  while (start <= reach) {
    const double way = start + place.metres;
    if (at.link == place.link && way >= 0) return way;
    start += run.link(at.link).length;
    if (go_on(run, driver, at) < 0) break;
  }
  return -1;
}

// The car for which an event fires now.
struct Due {
  bool now = false;
  int car = -1;
};

Due due_by_time(const CarRun& run, const EventRun& e) {
  if (run.time < e.event.at) return {};
  if (e.event.car_id) return {is_car(run, e.car, *e.event.car_id), e.car};
  if (!acts_on_a_car(e.event.kind)) return {true, -1};
  const int car =
      follower_of(run, e.event.place.link, e.event.place.metres, 0, usual_reach).car;
  return {car >= 0, car};
}

Due due_by_gap(const CarRun& run, const EventRun& e) {
  const LinkPlace& place = e.event.place;
  if (e.event.car_id) {
    if (!is_car(run, e.car, *e.event.car_id)) return {};
    const double way = way_to(run, e.car, place, e.event.at);
    return {way >= 0 && way <= e.event.at, e.car};
  }
  const Follower first = follower_of(run, place.link, place.metres, 0, e.event.at);
  return {first.car >= 0 && first.gap <= e.event.at, first.car};
}

Due due(const CarRun& run, const EventRun& e) {
  switch (e.event.trigger) {
    case EventTrigger::time: return due_by_time(run, e);
    case EventTrigger::gap: return due_by_gap(run, e);
    default:
      // Who left the network since can bring an event, and obey none.
      if (is_car(run, e.passed, e.passed_id)) return {true, e.passed};
      return {e.passed >= 0 && !acts_on_a_car(e.event.kind), -1};
  }
}

// Whether the lane keeps its room for those that were let in, or that pass it at once.
bool keeps_room(const CarRun& run, int link, double length) {
  Driver pulling;
  pulling.length = length;
  const double reserved = run.reserved[link];
  return !run.claims[link].empty() ||
         (reserved > 0 &&
          run.occupied[link] + reserved + run.room_of(pulling) > run.link(link).length);
}

// Nobody stands there, and who comes can stop behind.
bool has_room(const CarRun& run, const LinkPlace& place, double length) {
  if (keeps_room(run, place.link, length) ||
      run.cars.rear_on(place.link) < place.metres + beside_pulling)
    return false;
  const int ahead = run.cars.first_from(place.link, place.metres);
  if (ahead >= 0 && run.drivers[ahead].metres - run.drivers[ahead].length < place.metres + beside_pulling)
    return false;
  const Follower behind = follower_of(run, place.link, place.metres, length, usual_reach);
  if (behind.car < 0) return true;
  const double speed = run.drivers[behind.car].speed;
  return behind.gap > beside_pulling + speed * speed / (2 * run.rules.hardest_braking);
}

int pull_out(CarRun& run, const LinkPlace& place) {
  Car car;
  car.car_id = run.next_car_id++;
  car.length = run.rules.car_length;
  car.width = run.rules.car_width;
  car.place = place;
  ++run.entered;
  return put_car(run, car);
}

void fire(CarRun& run, int index, int car) {
  if (run.events[index].event.kind == EventKind::pull_out)
    car = pull_out(run, run.events[index].event.place);
  EventRun& e = run.events[index];
  e.fired = run.time;
  e.car = car;
  FiredEvent fired{e.event.event_id, run.time, {}, e.event.place};
  if (car >= 0) {
    const Driver& driver = run.drivers[car];
    fired.car_id = driver.car_id;
    fired.place = {driver.at.link, driver.metres};
    if (acts_on_a_car(e.event.kind)) run.drivers[car].event = index;
  }
  run.fired.push_back(fired);
}

// A place, and those beside it on all lanes of the street.
std::vector<LinkPlace> places_across(const TrafficNetwork& network, const LinkPlace& place) {
  std::vector<LinkPlace> places{place};
  for (std::size_t i = 0; i < places.size(); ++i)
    for (const bool left : {true, false}) {
      const LinkPlace next = beside(network, LinkPlace(places[i]), left).place;
      const auto same = [&](const LinkPlace& p) { return p.link == next.link; };
      if (next.link >= 0 && std::none_of(places.begin(), places.end(), same)) places.push_back(next);
    }
  return places;
}

}  // namespace

void check_events(const CarRun& run, const std::vector<TrafficEvent>& events) {
  for (const TrafficEvent& event : events) check_event(*run.network, run.rules, event);
}

void read_events(CarRun& run, const std::vector<TrafficEvent>& events) {
  run.events.clear();
  run.fired.clear();
  run.eventful.clear();
  if (!events.empty()) run.eventful.resize(run.network->size());
  for (const TrafficEvent& event : events) {
    EventRun e;
    e.event = event;
    for (std::size_t i = 0; i < run.drivers.size(); ++i)
      if (event.car_id && is_car(run, static_cast<int>(i), *event.car_id)) e.car = static_cast<int>(i);
    if (event.kind == EventKind::cross) e.across = places_across(*run.network, event.place);
    run.eventful[event.place.link] = 1;
    for (const LinkPlace& place : e.across) run.eventful[place.link] = 1;
    run.events.push_back(std::move(e));
  }
  for (Driver& driver : run.drivers) driver.event = -1;
}

void fire_events(CarRun& run) {
  for (std::size_t i = 0; i < run.events.size(); ++i) {
    const EventRun& e = run.events[i];
    if (e.has_fired()) continue;
    const Due found = due(run, e);
    if (!found.now || (e.event.kind == EventKind::pull_out &&
                       !has_room(run, e.event.place, run.rules.car_length)))
      continue;
    fire(run, static_cast<int>(i), found.car);
  }
}

}  // namespace streetgen
