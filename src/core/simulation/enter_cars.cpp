#include "simulation/enter_cars.hpp"

#include <algorithm>

#include "simulation/driver_sight.hpp"
#include "simulation/event_passing.hpp"
#include "simulation/let_in_cars.hpp"
#include "simulation/links_before.hpp"

namespace streetgen {

namespace {

constexpr double free_before = 30;  // metres before an entry amid the network without a car

// Whether nobody comes by the links before an entry.
bool nobody_comes(const CarRun& run, int link) {
  bool nobody = true;
  see_links_before(*run.network, link, 0, free_before, [&](int before, int, double) {
    nobody = nobody && run.cars.foremost(before) < 0;
    return nobody;
  });
  return nobody;
}

// A car enters as fast as it may, and does not have to brake more than comfortably.
bool enter(CarRun& run, const TrafficEntry& entry) {
  const Link& link = run.link(entry.link);
  Car car;
  car.car_id = run.next_car_id;
  car.length = run.rules.car_length;
  car.width = run.rules.car_width;
  car.route = entry.route;
  car.place = {entry.link, std::min<double>(link.length, car.length)};
  if (run.reserved[entry.link] > 0 || !nobody_comes(run, entry.link)) return false;
  if (link.opposite >= 0 ? others_on(run, link.opposite, -1) : !run.claims[entry.link].empty())
    return false;
  Driver driver;
  driver.car_id = car.car_id;
  driver.at = {entry.link, 1, entry.route < 0 ? -1 : 0};
  driver.route = entry.route;
  driver.metres = car.place.metres;
  driver.length = car.length;
  driver.kind = car.kind;
  Sight sight;
  look_ahead(run, driver, -1, run.cars.rearmost(entry.link), sight);
  if (sight.gap < run.rules.driver.least_gap) return false;
  const double braking = run.rules.driver.braking;
  for (const double speed : {static_cast<double>(link.speed), sight.leader_speed, 0.}) {
    driver.speed = std::min<double>(speed, link.speed);
    Sight ahead;
    look_ahead(run, driver, -1, run.cars.rearmost(entry.link), ahead);
    if (acceleration_of(run, driver, ahead) < -braking) continue;
    car.speed = driver.speed;
    note_passing(run, put_car(run, car), entry.link, before_start, car.place.metres);
    ++run.next_car_id;
    ++run.entered;
    return true;
  }
  return false;
}

}  // namespace

int put_car(CarRun& run, const Car& car) {
  const int index = run.cars.add(car);
  if (index >= static_cast<int>(run.drivers.size())) run.drivers.resize(index + 1);
  Driver& driver = run.drivers[index];
  driver = Driver();
  driver.car_id = car.car_id;
  driver.at = {car.place.link, 1, -1};
  driver.metres = car.place.metres;
  driver.speed = car.speed;
  driver.length = car.length;
  driver.route = car.route;
  driver.kind = car.kind;
  driver.here = true;
  for (EventRun& e : run.events)
    if (e.event.car_id == car.car_id) e.car = index;
  if (car.route >= 0) {
    const auto& route = run.cars.routes[car.route];
    const auto place = std::find(route.begin(), route.end(), car.place.link);
    if (place != route.end()) driver.at.on_route = static_cast<std::int32_t>(place - route.begin());
  }
  occupy(run, driver);
  if (run.guarded[car.place.link] || run.link(car.place.link).opposite >= 0)
    claim(run, index, car.place.link, -car.place.metres);
  return index;
}

void take_car(CarRun& run, int car) {
  Driver& driver = run.drivers[car];
  run.occupied[driver.at.link] -= run.room_of(driver);
  give_up_all(run, car);
  driver.here = false;
  run.cars.remove(car);
}

void enter_cars(CarRun& run, double step) {
  for (std::size_t i = 0; i < run.entries.size(); ++i) {
    CarRun::Entry& e = run.entries[i];
    if (e.entry.flow <= 0) continue;
    while (e.next < run.time + step) {
      ++e.waiting;
      // From half to one and a half of the mean time.
      e.next += (0.5 + drawn(run.seed, ~static_cast<std::uint64_t>(i), ++e.drawn)) / e.entry.flow;
    }
    if (e.waiting > 0 && enter(run, e.entry)) --e.waiting;
  }
}

}  // namespace streetgen
