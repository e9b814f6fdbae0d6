// Limits that lie before the place where kerbs part.
#pragma once

#include "layout/layout.hpp"
#include "layout/node_corner.hpp"

namespace streetgen {

// Brings the limits of a corner to about `limit_distance` metres from its node, where the kerbs of
// its arms part slowly and its arc lies farther away.
void bring_limits_near(const Arm& a, const Arm& b, double limit_distance, SolvedCorner& corner);

// Once limits are settled: what parts the sections behind limits before their arc.  Gives the edges
// of corners where nothing does: `wanted`, the limits by slot, are then those at the arc.
std::vector<int> part_sections(Layout& layout, std::vector<double>& wanted);

// Border lines of parted sections end on what parts them.
void end_borders_on_partings(Layout& layout);

SectionPartings partings_of(const Layout& layout, int edge);

}  // namespace streetgen
