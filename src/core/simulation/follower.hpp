// Who comes next behind a place.
#pragma once

#include "simulation/driver.hpp"

namespace streetgen {

struct Follower {
  int car = -1;
  double gap = no_end;  // from its front to the rear at the place
};

// The nearest car behind the rear of who is at metres of a link, no farther than `reach` on the
// links before.
Follower follower_of(const CarRun& run, int link, double metres, double length, double reach);

}  // namespace streetgen
