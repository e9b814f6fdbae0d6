// The circle nearest to points.
#pragma once

#include <cstddef>
#include <optional>

#include "geometry/circle.hpp"
#include "streetgen/geometry.hpp"

namespace streetgen {

// Of the least squares of the distances of `count` points, from the algebraic circle of Kasa on,
// in at most twenty steps of Gauss and Newton.  None where the points lie on a line, or are less
// than three.
std::optional<Circle> fit_circle(const Point* points, std::size_t count);

}  // namespace streetgen
