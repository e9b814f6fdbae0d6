// Measures of a highway that goes on past the node where a ramp meets it.
#pragma once

#include <cmath>

#include "geometry/tolerance.hpp"

namespace streetgen {

// The cosine of the largest turn of a highway that goes on.
const double highway_straightest = std::cos(M_PI / 6 + same_angle);
// Metres from the node, to tell directions.
constexpr double highway_look = 10;
// Metres, of the least taper of a merging lane.
constexpr double least_taper = 1;

}  // namespace streetgen
