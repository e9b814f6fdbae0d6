#pragma once

#include "streetgen/geometry.hpp"

namespace streetgen {

// The ring without sides that run back along each other: borders that coincide but for the noise
// of coordinates leave such a hairline between them.  Empty where nothing else is.
Ring without_hairlines(const Ring& ring);

}  // namespace streetgen
