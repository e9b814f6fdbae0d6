// Rings that meet neither themselves nor each other.
#pragma once

#include <optional>

#include "streetgen/geometry.hpp"

namespace streetgen {

// False where sides of the surface's rings cross, true where all keep apart but for the ends that
// follow each other; none where some come nearer than a tenth of a micrometre, unless a side
// shorter than that lies between them on one way.
std::optional<bool> simple(const MultiPolygon& surface);

}  // namespace streetgen
