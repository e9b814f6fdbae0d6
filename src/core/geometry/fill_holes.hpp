// Small holes within one surface are filled.
#pragma once

#include "streetgen/geometry.hpp"

namespace streetgen {

// Removes the interior rings whose area is under `max_area` square metres.
void fill_holes(MultiPolygon& surface, double max_area);

}  // namespace streetgen
