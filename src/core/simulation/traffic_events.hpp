// Events of a simulation of cars: when they fire.
#pragma once

#include <vector>

#include "simulation/driver.hpp"

namespace streetgen {

// Refuses (invalid_input) what CarFollowing::set_events says.
void check_events(const CarRun& run, const std::vector<TrafficEvent>& events);
void read_events(CarRun& run, const std::vector<TrafficEvent>& events);

// Those whose trigger came since the last step.
void fire_events(CarRun& run);

}  // namespace streetgen
