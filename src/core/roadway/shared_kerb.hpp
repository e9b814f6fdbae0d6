// Kerbs between two corners that are too short for the arcs of both.
#pragma once

#include "layout/layout.hpp"
#include "roadway/island.hpp"

namespace streetgen {

// Where two arcs would lie upon each other on one kerb each gets, as SolvedCorner::ends, half of
// what lies between the crossings of the kerbs, or what the other leaves of it; nothing where these
// crossings pass each other. Each corner adds the nodes that it looked at to Junction::followed.
void share_kerbs(Layout& layout, SolvedCorners& corners);

}  // namespace streetgen
