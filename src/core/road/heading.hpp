// Directions and their headings, radians counter-clockwise from east.
#pragma once

#include <cmath>

#include "geometry/polyline.hpp"

namespace streetgen {

inline double heading_of(const Point& direction) { return std::atan2(direction.y, direction.x); }
inline Point along(double heading) { return {std::cos(heading), std::sin(heading), 0}; }
// From one direction to another, the shorter way.
inline double turn_from(const Point& from, const Point& to) {
  return std::atan2(cross(from, to), dot(from, to));
}

}  // namespace streetgen
