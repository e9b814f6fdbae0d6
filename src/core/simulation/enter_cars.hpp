// Cars that come from outside.
#pragma once

#include "simulation/driver.hpp"

namespace streetgen {

// Puts a car on the network, whether it has room or not.  Its index.
int put_car(CarRun& run, const Car& car);
// The car leaves the network.
void take_car(CarRun& run, int car);
// Cars that are due come in where they have room; others wait.
void enter_cars(CarRun& run, double step);

}  // namespace streetgen
