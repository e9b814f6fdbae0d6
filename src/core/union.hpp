// The union of a few polygons.
#pragma once

#include "streetgen/geometry.hpp"

namespace streetgen {

// By the faces that they make together. Rings may cross themselves: what lies in an odd number of a
// polygon's rings is in it. Their vertices stay where they are; the work grows with their square.
MultiPolygon united(const std::vector<MultiPolygon>& parts);

}  // namespace streetgen
