#include "simulation/follower.hpp"

#include "simulation/links_before.hpp"

namespace streetgen {

namespace {

// The nearest car that comes to a link from those before it.
Follower follower_before(const CarRun& run, int link, double way_back, double reach) {
  Follower found;
  see_links_before(*run.network, link, way_back, reach, [&](int before, int next, double way) {
    const int car = run.cars.foremost(before);
    if (car < 0) return true;
    const Driver& driver = run.drivers[car];
    WayPlace at = driver.at;
    if (go_on(run, driver, at) != next) return false;
    const double gap = way + run.link(before).length - driver.metres;
    if (gap < found.gap) found = {car, gap};
    return false;
  });
  return found;
}

}  // namespace

Follower follower_of(const CarRun& run, int link, double metres, double length, double reach) {
  const int car = run.cars.last_before(link, metres);
  if (car < 0) return follower_before(run, link, metres - length, reach);
  return {car, metres - length - run.drivers[car].metres};
}

}  // namespace streetgen
