// Where surfaces leave little room between each other.
#pragma once

#include <vector>

#include "geometry/box.hpp"
#include "streetgen/geometry.hpp"

namespace streetgen {

// Boxes about all holes under `max_area` square metres in the union of the surfaces that more than
// one of them borders on; a box may hold none. A hole in which no disc of that area has room has a
// border on which no such disc can lie.
std::vector<Box> narrow_gaps(const std::vector<const MultiPolygon*>& surfaces, double max_area);

}  // namespace streetgen
