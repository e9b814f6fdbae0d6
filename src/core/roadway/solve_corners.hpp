// The corners of every node.  StreetGen paper, section 2.4.
#pragma once

#include "layout/layout.hpp"
#include "roadway/street_override.hpp"

namespace streetgen {

// Corners, gaps and transitions come out, and how far each arm's limit must lie for them.
void solve_corners(Layout& layout, const RadiiByHand& by_hand);

// Once merging lanes are settled: the corners between two edges that they lie on, at their width
// there.  It is no more than what the limits were solved for.
void solve_joints(Layout& layout, const RadiiByHand& by_hand);

}  // namespace streetgen
