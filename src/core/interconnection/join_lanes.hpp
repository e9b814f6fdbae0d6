// The lanes that each lane goes on to at one node where one drives on the right, whoever may drive.
#pragma once

#include "interconnection/movement.hpp"

namespace streetgen {

// Fills the verdicts.
void join_lanes(const std::vector<Leg>& legs, std::vector<Movement>& movements);

}  // namespace streetgen
