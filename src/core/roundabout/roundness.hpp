// How round a ring is.
#pragma once

#include <optional>

#include "geometry/circle.hpp"
#include "streetgen/geometry.hpp"

namespace streetgen {

struct Roundness {
  Circle circle;  // of least squares
  double compactness = 0;
  double on_circle = 0;  // share of the line within a tenth of the radius of the circle
};

// Area by that of the circle of the same length, as Polsby and Popper; of a closed line, clockwise
// ones negative.
double compactness_of(const Ring& line);

// None where no circle fits the line.
std::optional<Roundness> roundness_of(const Ring& line);

// Whether two rings may be the halves of a double roundabout: both compact by 0.9 and more, neither
// with more than twice the radius of the other.
bool are_halves(const Roundness& a, const Roundness& b);

// The less round half of a peanut: the narrowest place of the line parts two halves, each with a
// third of the line and more. None where that place is no waist: the line bends inwards on both
// sides of it.
std::optional<Roundness> less_round_half(const Ring& line);

}  // namespace streetgen
