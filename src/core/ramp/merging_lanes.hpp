// Merging lanes along a highway from its ramps, over nodes that only join two edges of it.
#pragma once

#include "layout/layout.hpp"

namespace streetgen {

// Fills Layout::merging_runs, and gives the arms of the highways their merging lanes: of full width
// at each node that these may reach, as limits are not known.
void give_merging_lanes(Layout& layout, const RampRules& rules);

// Once limits are known: merging lanes end before the intersection at the end of their run, and
// roadways have them.
void settle_merging_lanes(Layout& layout);

}  // namespace streetgen
