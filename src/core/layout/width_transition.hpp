// Where two axes of different width meet, and where one ends.  Paper, 2.5 (variable buffer).
#pragma once

#include <cmath>

#include "geometry/tolerance.hpp"
#include "layout/surface_ring.hpp"
#include "streetgen/street.hpp"

namespace streetgen {

constexpr double widest_bend = M_PI / 3 + same_angle;  // beyond it no axis goes on from another

// Two axes of different width, or beside their roadways otherwise, that go on from one another.
bool changes_width(const Arm& a, const Arm& b);

// Metres that the kerb moves sideways which goes on from the left of a to the right of b.
double sideways(const Arm& a, const Arm& b);

// Metres that a kerb wants to move so far sideways where the length is not said.
double taper_length(double sideways, double speed, const TaperRatio& ratio);

// How far from its node a transition of that length is wanted to reach on an arm.
double transition_limit(const Arm& arm, double length);

// The length on which a kerb steps that does not change linearly.
double step_length(double limit_a, double limit_b);

// From a's limit through the node to b's.  symmetric: both kerbs change linearly;
// left, right: that kerb does, seen from a to b, the other steps at the node.
MultiPolygon build_transition(Geos& geos, const Arm& a, const Arm& b, TransitionKind kind);

// With half a disc at the arm's node.
MultiPolygon with_round_end(Geos& geos, const MultiPolygon& surface, const Arm& arm);

}  // namespace streetgen
