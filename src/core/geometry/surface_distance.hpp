// Do two surfaces come near each other?
#pragma once

#include "streetgen/geometry.hpp"

namespace streetgen {

// Whether they share ground or come within `reach` metres of each other.
bool come_near(const MultiPolygon& a, const MultiPolygon& b, double reach);

}  // namespace streetgen
