// Where the section of each edge ends and the intersections at its nodes begin.
#pragma once

#include "layout/layout.hpp"
#include "roadway/street_override.hpp"

namespace streetgen {

// From what the corners ask of each arm, and what was decided by hand; border lines too.
void settle_limits(Layout& layout, const LimitsByHand& by_hand);

}  // namespace streetgen
