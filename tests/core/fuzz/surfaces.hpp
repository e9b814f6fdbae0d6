// Whether a surface may be given to anyone.
#pragma once

#include "streetgen/geometry.hpp"

namespace streetgen::fuzz {

// Valid and finite; an empty one is.
bool sound(const MultiPolygon& surface);

}  // namespace streetgen::fuzz
