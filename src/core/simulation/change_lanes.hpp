// Lane changes: for a route, out of a lane that ends, and for speed, by MOBIL.
#pragma once

#include "simulation/driver.hpp"

namespace streetgen {

// Lets each driver look beside once in an interval; one after the other, so that none meet.
void change_lanes(CarRun& run, double step);

}  // namespace streetgen
