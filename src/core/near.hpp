// How near the borders of two surfaces come to each other.
#pragma once

#include "streetgen/geometry.hpp"

namespace streetgen {

// Whether they come within `reach` metres of each other. Of surfaces that share no ground.
bool come_near(const MultiPolygon& a, const MultiPolygon& b, double reach);

}  // namespace streetgen
