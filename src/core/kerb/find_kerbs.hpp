// The border of the roadway: kerbs of sections and intersections.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "layout/layout.hpp"
#include "roadway/find_affected.hpp"

namespace streetgen {

// Fills the kerbs of `layout.streets`: of what is affected, and of what lies along ground that
// changed. Beyond reach the neighbours hold the ground. Where they are unknown, edges and nodes do
// as settled (`beyond_reach`, as settle_owners gives it), or else as they claim it.
void find_kerbs(Layout& layout, const Affected& moved,
                const std::map<int, MultiPolygon>& beyond_reach,
                const std::optional<std::vector<Neighbour>>& neighbours);

}  // namespace streetgen
