// Arrows on lanes show where these lead.
#pragma once

#include <vector>

#include "streetgen/interconnection.hpp"

namespace streetgen {

// An arrow on a lane without marks shows the ways that the lane takes, and stands only where two
// lanes of its arm have no way in common; marks lose the way straight on where there is none. The
// ways are those of the lines and wishes, so that an arrow at the far end of an edge is known
// before its paths are.
void point_arrows(const Streets& streets, const std::vector<TurnRestriction>& restrictions,
                  const std::vector<Circulation>& circulations, const WishedLanes& wished,
                  DrivingSide driving_side, double node_tolerance, Lanes& lanes);

}  // namespace streetgen
