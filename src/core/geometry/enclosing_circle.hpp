// The smallest circle about points.
#pragma once

#include "geometry/circle.hpp"
#include "streetgen/geometry.hpp"

namespace streetgen {

// Welzl, Smallest enclosing disks, 1991, in the order of the points; of one place a circle of
// radius 0.  Throws nothing on an empty list: the circle about the origin.
Circle enclosing_circle(const Line& points);

}  // namespace streetgen
