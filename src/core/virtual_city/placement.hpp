// Where axes that were drawn about a place of their own come to lie.
#pragma once

#include <cmath>
#include <vector>

#include "geometry/polyline.hpp"
#include "streetgen/error.hpp"
#include "virtual_city/portable_math.hpp"

namespace streetgen {

// The lower left corner of an extent.
inline void check_corner(double x, double y) {
  if (!(std::fabs(x) <= 1e9 && std::fabs(y) <= 1e9))
    throw Error(ErrorKind::invalid_input,
                "the lower left corner is " + text_of(x) + ", " + text_of(y) +
                    ", expected metres up to 1e9",
                "Give the corner in the coordinates of the SRID.");
}

// Moves axes from one point to another, on whole millimetres.
template <class Axis>
void move_axes(std::vector<Axis>& axes, const Point& from, const Point& to) {
  const Point there = portable::to_millimetre(to);
  for (Axis& axis : axes)
    for (Point& p : axis.line) p = portable::to_millimetre(p - from + there);
}

}  // namespace streetgen
