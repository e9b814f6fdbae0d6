// Paths that turn too tightly for their speed, or with a corner.
#pragma once

#include "interconnection/way.hpp"

namespace streetgen {

// A tight path goes where both its lanes have another, or one that is neither tight nor back; of an
// ordinary turn, its movement too.  One with a corner says so where it stays as the only way.
void drop_tight_paths(const Ways& of_node);

}  // namespace streetgen
