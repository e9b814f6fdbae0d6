// Notches in the outline of the roadway: ground between two surfaces whose borders cross.
#pragma once

#include <functional>
#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

// Across the ground at each place where the borders of two surfaces cross and leave a wedge of less
// than 135 degrees: an arc of `radius` metres that touches both borders, smaller where it would
// begin farther than 1.5 m from the place, none under 0.1 m. `is_free` says of a place whether no
// other surface has it.
std::vector<Line> across_notches(const MultiPolygon& a, const MultiPolygon& b, double radius,
                                 const std::function<bool(const Point&)>& is_free);

}  // namespace streetgen
