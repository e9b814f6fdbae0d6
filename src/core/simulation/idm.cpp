#include <algorithm>
#include <cmath>

#include "streetgen/car_following.hpp"

namespace streetgen {

double idm_acceleration(const DriverModel& driver, const Following& f) {
  const double share = f.speed / f.desired_speed;
  double wish = 1 - share * share * share * share;
  if (std::isfinite(f.gap)) {
    const double closing = f.speed * (f.speed - f.leader_speed) /
                           (2 * std::sqrt(driver.acceleration * driver.braking));
    const double wanted = driver.least_gap + std::max(0., f.speed * driver.time_gap + closing);
    const double near = wanted / std::max(f.gap, 1e-3);
    wish -= near * near;
  }
  return driver.acceleration * wish;
}

double idm_equilibrium_gap(const DriverModel& driver, double speed, double desired_speed) {
  const double share = speed / desired_speed;
  return (driver.least_gap + speed * driver.time_gap) /
         std::sqrt(1 - share * share * share * share);
}

}  // namespace streetgen
