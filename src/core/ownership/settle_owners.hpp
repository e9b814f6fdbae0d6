// Sections and intersections: the ground that each of them owns.
#pragma once

#include <map>

#include "layout/layout.hpp"
#include "roadway/find_affected.hpp"

namespace streetgen {

// Builds the sections and intersections of the affected edges and nodes, and only the surfaces that
// these depend on. Every edge and node that claims the same ground as a moved one becomes affected
// too. Gives the ground of edges and nodes beyond reach as far as it was settled with them, by
// number: edges first, then nodes. With border, these tell that of each level.
std::map<int, MultiPolygon> settle_owners(Layout& layout, const Affected& moved, bool with_border);

}  // namespace streetgen
