// Sections and intersections: the ground that each of them owns.
#pragma once

#include "roadway/find_affected.hpp"
#include "roadway/layout.hpp"

namespace streetgen {

// Those of asked edges and nodes come out; whatever claims the same ground as moved ones is asked
// for too. Only what these depend on is built.
void settle_owners(Layout& layout, const Moved& moved);

}  // namespace streetgen
