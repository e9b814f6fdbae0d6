// Which ways of the next junction each lane of a short edge serves there.
#pragma once

#include <vector>

#include "interconnection/movement.hpp"
#include "streetgen/network.hpp"

namespace streetgen {

// A leg of the next junction as its line and the wishes have it: seen so, it is known before its
// ground is.
Leg foreseen_leg(const Edge& edge, bool at_start, const std::vector<LaneWish>& lanes);

// The movements from one leg to the others, before what restricts them.
std::vector<Movement> foreseen_movements(const std::vector<Leg>& legs, int from);

// For each lane that comes by the leg, the legs that it serves, a bit each.
std::vector<unsigned> served_ahead(const std::vector<Leg>& legs, int from,
                                   std::vector<Movement>& movements, DrivingSide driving_side);

}  // namespace streetgen
