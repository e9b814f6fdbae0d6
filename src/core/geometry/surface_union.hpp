// The union of a few polygons.
#pragma once

#include <vector>

#include "geometry/geos.hpp"
#include "streetgen/geometry.hpp"

namespace streetgen {

// By the faces that they make together. Rings may cross themselves: what lies in an odd number of a
// polygon's rings is in it. Vertices stay where they are, or nearly. The work grows with their
// square.
MultiPolygon united_as_they_lie(Geos& geos, const std::vector<MultiPolygon>& parts);

// The same, but vertices within a micrometre of each other become one.
MultiPolygon united(Geos& geos, const std::vector<MultiPolygon>& parts);

}  // namespace streetgen
