// Drivers obey events that fired.
#pragma once

#include "simulation/driver.hpp"

namespace streetgen {

// Metres to where a driver stops for somebody who crosses a link that starts so far ahead;
// infinite: nobody does, or the driver could not stop before.
double to_walker(const CarRun& run, const Driver& driver, int link, double to_start);
// The acceleration of a driver who obeys an event, in place of that by the law.
double obeyed(const CarRun& run, const Driver& driver, double acceleration, double step);
// Metres a second by which a driver is faster than allowed.
double faster_by(const CarRun& run, const Driver& driver);
// Whether a driver still has to change lanes to pass.
bool overtakes(const CarRun& run, const Driver& driver);

}  // namespace streetgen
