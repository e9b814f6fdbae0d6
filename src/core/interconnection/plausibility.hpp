// The lanes that each lane goes on to at one node.  docs/concepts/geometry.md, Plausible.
#pragma once

#include <vector>

#include "interconnection/movement.hpp"

namespace streetgen {

// Fills the verdicts.  At most one movement from a leg to a leg.  Where one drives on the left, all
// is as in the mirror on the right.
void choose_lanes(const std::vector<Leg>& legs, std::vector<Movement>& movements,
                  DrivingSide driving_side);

}  // namespace streetgen
