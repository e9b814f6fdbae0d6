// Events of a simulation of cars: when they fire.
#pragma once

#include <vector>

#include "simulation/driver.hpp"

namespace streetgen {

// Refuses (invalid_input) what CarFollowing::set_events says.
void check_events(const TrafficNetwork& network, const std::vector<TrafficEvent>& events);
void read_events(CarRun& run, const std::vector<TrafficEvent>& events);

// The front of a car goes along a link: who passes the place of an event brings it.
void note_passing(CarRun& run, int car, int link, double from, double to);
// Those whose trigger came since the last step.
void fire_events(CarRun& run);

}  // namespace streetgen
