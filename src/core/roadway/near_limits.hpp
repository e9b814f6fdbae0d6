// Limits that lie before the place where kerbs part.
#pragma once

#include "layout/layout.hpp"
#include "layout/node_corner.hpp"

namespace streetgen {

// Brings the limits of a corner to about `limit_distance` metres from its node, where the kerbs of
// its arms part slowly and its arc lies farther away.
void bring_limits_near(const Arm& a, const Arm& b, double limit_distance, SolvedCorner& corner);

// Once limits of some edges are settled: what parts the sections behind limits before their arc,
// which becomes smaller where a section ends before it.  Gives the edges whose limits have to move,
// to what `wanted` says by slot: as far as that of their neighbour, or to the arc where nothing
// parts them; it is as small then as brings them near.
std::vector<int> part_sections(Layout& layout, const std::vector<bool>& settled,
                               std::vector<double>& wanted);

// Border lines of parted sections end on what parts them.
void end_borders_on_partings(Layout& layout);

// Metres from a node up to which the kerb on a side of an edge is free for what lies at that node:
// from there on it has the limit, or the arc of a corner, at the far end.
double kerb_room(const Layout& layout, const EdgeEnd& end, int side);

SectionPartings partings_of(const Layout& layout, int edge);

}  // namespace streetgen
