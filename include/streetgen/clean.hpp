// The filters of "GIS data to functional road models", section 3.4, on one whole axis.
#pragma once

#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

// Removes points closer than `epsilon` to the last kept one, then collinear points (closer
// than 1e-3 m to the chord), then points where r_min tan(theta / 2) exceeds half of either
// neighbouring segment (theta: the turn there).  Never the ends, nor a point i with keep[i].
// keep is empty or as long as the line.  Lengths in metres.
Line clean(const Line& line, const std::vector<bool>& keep, double epsilon, double r_min);

}  // namespace streetgen
