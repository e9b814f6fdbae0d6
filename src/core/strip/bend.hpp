// How strips behind kerbs go about a bend.
#pragma once

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"

namespace streetgen {

constexpr int bend_quarter = 8;         // chords of a quarter circle
constexpr double chord_cosine = 0.966;  // of 15 degrees: from chord to chord of an arc

// Directions before and after it; the strip lies on the left. Chords of an arc make no bend.
inline bool is_outer_bend(const Point& before, const Point& after) {
  return cross(before, after) < -straight_sine && dot(before, after) < chord_cosine;
}

// From an outer bend to the middle of what lies about it: a unit vector.
inline Point middle_of_bend(const Point& before, const Point& after) {
  return unit(before - after);
}

}  // namespace streetgen
