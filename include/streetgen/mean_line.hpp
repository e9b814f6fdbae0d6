// The line in the middle of several.
#pragma once

#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

// At each share of its length, the mean of the places that the lines have there; it has a vertex
// wherever one of them has. Planar. Of one line that line, without repeated points; of none, or
// where the mean is one place alone, nothing.
Line mean_line(const std::vector<Line>& lines);

}  // namespace streetgen
