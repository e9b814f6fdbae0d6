// Cars that pass the places of events.
#pragma once

#include <cstdint>

#include "simulation/driver.hpp"

namespace streetgen {

// Whether an index is that of a car of this key, on the network.
bool is_car(const CarRun& run, int car, std::int64_t car_id);

// The front of a car goes along a link: who passes the place of an event brings it.  Who comes onto
// the link comes from before its start.
constexpr double before_start = -1;
void note_passing(CarRun& run, int car, int link, double from, double to);

}  // namespace streetgen
