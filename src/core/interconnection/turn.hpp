// The turn of a path from one lane to another, and what that is called.
#pragma once

#include "streetgen/geometry.hpp"
#include "streetgen/interconnection.hpp"

namespace streetgen {

// Degrees in (-180, 180], positive to the left.
double turn_angle(const Point& from, const Point& to);
Turn turn_of(double angle);
// As traffic calls it: only what turns back is a U-turn, and another turn as sharp leads to its
// side, left where `side` is positive.
Turn turn_called(bool turns_back, double angle, double side);

}  // namespace streetgen
