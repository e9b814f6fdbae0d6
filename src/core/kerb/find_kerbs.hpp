// The border of the roadway: kerbs of sections and intersections.
#pragma once

#include <map>

#include "roadway/find_affected.hpp"
#include "roadway/layout.hpp"

namespace streetgen {

// Fills the kerbs of `layout.streets`: of what is affected, and of what lies along ground that
// changed. `beyond_reach`: settled ground of other edges and nodes, as settle_owners gives it.
void find_kerbs(Layout& layout, const Affected& moved,
                const std::map<int, MultiPolygon>& beyond_reach);

}  // namespace streetgen
