// Vectors in space: the same words as of the plane, with z.
#pragma once

#include <cmath>

#include "geometry/polyline.hpp"
#include "streetgen/geometry.hpp"

namespace streetgen::space {

inline double dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Point cross(const Point& a, const Point& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double norm(const Point& a) { return std::sqrt(space::dot(a, a)); }
inline double distance(const Point& a, const Point& b) { return space::norm(a - b); }
// Zero stays zero.
inline Point unit(const Point& a) {
  const double n = space::norm(a);
  return n > 0 ? Point{a.x / n, a.y / n, a.z / n} : Point{};
}

}  // namespace streetgen::space
