// Streets that a source has twice: lines that lie on one another.
#pragma once

#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

// The metres of each line that lie on one other line of its level, on that where they are most:
// beside its segments, no farther than `near` from them and turned from them by less than ten
// degrees, in either direction.  Lines that meet at an angle share no more than their node.
std::vector<double> doubled(const std::vector<Line>& lines, const std::vector<int>& levels,
                            double near);

}  // namespace streetgen
