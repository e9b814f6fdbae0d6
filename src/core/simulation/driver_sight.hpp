// What a driver sees ahead, and what follows from it.
#pragma once

#include <vector>

#include "simulation/driver.hpp"

namespace streetgen {

// From a place of the driver; `ahead` is the next car on its link, -1: none.  `itself`: the car.
void look_ahead(const CarRun& run, const Driver& driver, int itself, int ahead, Sight& sight);

// Seconds for metres from a speed, up to another one.
double seconds_for(double metres, double speed, double most);

// Adds what the law is asked: rows of one driver.
void ask_law(const CarRun& run, const Driver& driver, const Sight& sight,
             std::vector<Following>& rows);
// The acceleration by the answers to those rows: the least one, and of a claim the greater one of
// its two.  Moves on to the answers of the next driver.
double take_answer(const CarRun& run, const Sight& sight, const double*& answers);
// The same for one driver alone.
double acceleration_of(const CarRun& run, const Driver& driver, const Sight& sight);
void answer(const CarRun& run, const std::vector<Following>& rows, std::vector<double>& answers);

}  // namespace streetgen
