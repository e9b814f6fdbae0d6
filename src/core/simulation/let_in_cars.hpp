// Who may enter a movement that others cross, and a lane for both directions.
#pragma once

#include "simulation/driver.hpp"

namespace streetgen {

// Lets in those who asked, one after the other: who waits longest, then who is nearest.
void let_in_cars(CarRun& run);
// Whether a driver may have to wait at the end of its link: it was let in no farther, or there.
bool may_wait(const Driver& driver);
// A driver who was let in waits again, unless it has begun to enter.
void take_back(CarRun& run, int car);
void give_up_all(CarRun& run, int car);
// A car has come to a link: its room there is no longer reserved but taken.
void occupy(CarRun& run, Driver& driver);
// Gives up the claims of a car that are behind it.
void give_up_claims(CarRun& run, int car);
// Whether somebody else is on a lane for both directions, or was let in to it.
bool others_on(const CarRun& run, int link, int car);
// Claims a link on which a car stands without having been let in.
void claim(CarRun& run, int car, int link, double to_start);

}  // namespace streetgen
