// How a sidewalk ends at the corner of a street that has none.
#pragma once

#include <vector>

#include "sidewalk/kerb_chain.hpp"

namespace streetgen {

// Its back line goes straight on, to where the kerb meets it: counter-clockwise, what lies between
// both. Where that is farther than `reach` from the first kerb of the way, it ends square at the
// end of the way. Empty where the kerb turns away from the sidewalk, so that it ends square at
// once.
Ring straight_end(const std::vector<SidewalkKerb>& kerbs, const SidewalkEnd& end, double reach);

}  // namespace streetgen
