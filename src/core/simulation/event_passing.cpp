#include "simulation/event_passing.hpp"

namespace streetgen {

bool is_car(const CarRun& run, int car, std::int64_t car_id) {
  return car >= 0 && run.drivers[car].here && run.drivers[car].car_id == car_id;
}

void note_passing(CarRun& run, int car, int link, double from, double to) {
  if (run.eventful.empty() || !run.eventful[link]) return;
  for (EventRun& e : run.events) {
    const LinkPlace& place = e.event.place;
    if (e.has_fired() || is_car(run, e.passed, e.passed_id) || place.link != link ||
        !(from < place.metres && place.metres <= to))
      continue;
    const std::int64_t car_id = run.drivers[car].car_id;
    if (e.event.car_id && e.event.car_id != car_id) continue;
    e.passed = car;
    e.passed_id = car_id;
  }
}

}  // namespace streetgen
