#include "simulation/event_obeyed.hpp"

#include <algorithm>

namespace streetgen {

namespace {

constexpr double before_walker = 1;   // metres that a car stops before somebody who crosses
constexpr double walker_braking = 6;  // who must brake harder passes

double until(const EventRun& e) { return e.fired + e.event.duration; }

const EventRun* event_of(const CarRun& run, const Driver& driver) {
  if (driver.event < 0) return nullptr;
  const EventRun& e = run.events[driver.event];
  return run.time < until(e) ? &e : nullptr;
}

}  // namespace

double to_walker(const CarRun& run, const Driver& driver, int link, double to_start) {
  double nearest = no_end;
  if (run.eventful.empty() || !run.eventful[link]) return nearest;
  for (const EventRun& e : run.events) {
    if (e.across.empty() || !e.has_fired() || run.time >= until(e)) continue;
    for (const LinkPlace& place : e.across) {
      const double way = to_start + place.metres - before_walker;
      if (place.link == link && way > 0 &&
          driver.speed * driver.speed <= 2 * walker_braking * way)
        nearest = std::min(nearest, way);
    }
  }
  return nearest;
}

double obeyed(const CarRun& run, const Driver& driver, double acceleration, double step) {
  const EventRun* e = event_of(run, driver);
  if (!e || e->event.kind == EventKind::overtake) return acceleration;
  const double target = e->event.kind == EventKind::brake ? e->event.speed : 0;
  return std::min(acceleration,
                  std::max(-e->event.deceleration, (target - driver.speed) / step));
}

double faster_by(const CarRun& run, const Driver& driver) {
  const EventRun* e = event_of(run, driver);
  return e && e->event.kind == EventKind::overtake ? e->event.speed : 0;
}

bool overtakes(const CarRun& run, const Driver& driver) {
  const EventRun* e = event_of(run, driver);
  return e && e->event.kind == EventKind::overtake && driver.changed < e->fired;
}

}  // namespace streetgen
