// The angle of a movement, from its leftmost lanes.
#pragma once

#include "interconnection/movement.hpp"

namespace streetgen {

// A number of steps of 0.0001 degrees: angles that differ by noise are equal.  The bounds lie
// beside round angles, at which streets are drawn.
long long in_steps(double degrees);

// Degrees, positive to the left; of one that turns back, to the side on which it does.
double movement_angle(const Leg& from, const Leg& to);

// Degrees, positive to the left: by the streets as they leave the node, which may bend before their
// lanes end there.
double outset_angle(const Leg& from, const Leg& to);

// The greater, the farther to the left: by the angle and by where the movement leads.
double movement_order(const Leg& from, const Leg& to);

}  // namespace streetgen
