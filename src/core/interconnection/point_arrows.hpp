// Arrows on lanes that do not lead straight on.
#pragma once

#include <vector>

#include "streetgen/interconnection.hpp"

namespace streetgen {

// An arrow on a lane without marks shows the turns that the lane takes at a node of three edges and
// more, unless it leads straight on too; marks lose the way straight on where there is none. The
// ways are those of the lines and wishes, so that an arrow at the far end of an edge is known
// before its paths are.
void point_arrows(const Streets& streets, const std::vector<TurnRestriction>& restrictions,
                  const std::vector<Circulation>& circulations, const WishedLanes& wished,
                  DrivingSide driving_side, double node_tolerance, Lanes& lanes);

}  // namespace streetgen
