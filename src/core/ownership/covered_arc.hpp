// The arc of a corner is kerb where no roadway lies behind it.
#pragma once

#include <functional>
#include <vector>

#include "streetgen/street.hpp"

namespace streetgen {

// Whether roadway lies behind most of an arc, on the side of its centre.
bool covered(const Corner& corner, const std::function<bool(const Point&)>& on_roadway);

// Takes away the arcs that are covered.
void leave_covered_arcs(std::vector<Corner>& corners);

}  // namespace streetgen
