// The ground that two lines have in common, side by side: which lines of two data sets are one
// street.
#pragma once

#include "streetgen/geometry.hpp"

namespace streetgen {

// Both lines are dilated by `distance`, metres.  The result is the share of the ground of `line`, 0
// to 1, that lies on the ground of `other` where the two go side by side: within 30 degrees of one
// direction, either way, and abreast.  Where they part by g it is 1 - g / (2 distance), as of two
// strips; a street that crosses shares nothing.  A line without length shares nothing.  Places are
// taken along `line`, a metre apart and at most a thousand.  StreetGen paper, section 3.1, which
// compares dilated axes.
double common_ground(const Line& line, const Line& other, double distance);

}  // namespace streetgen
