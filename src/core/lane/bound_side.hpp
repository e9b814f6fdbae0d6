// The side of a bound on which a place lies, as readers of Lanelet2 tell it.
#pragma once

#include "streetgen/geometry.hpp"

namespace streetgen {

// Whether the place lies left of the side of the line that is nearest to it.
bool lies_left(const Line& line, const Point& place);

// The point in the middle of the list of points, the second one of two; the middle of a line of
// two.
Point middle_point(const Line& line);

// Whether a reader takes both lines, of two points at least, as they are: the left and the right
// bound of a lanelet in their common direction, or of one against it.  It looks where the middle
// point of each lies, and turns those round that lie on the wrong side.
bool are_bounds(const Line& left, const Line& right);

}  // namespace streetgen
