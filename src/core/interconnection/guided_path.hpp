// A path that follows the edges inside a junction, its corners rounded.
#pragma once

#include "interconnection/junction_route.hpp"
#include "interconnection/movement.hpp"
#include "streetgen/junction_movement.hpp"

namespace streetgen {

// From the end of a lane along the lanes of the route's edges to the start of a lane, tangent to
// both: straight pieces and arcs as wide as the pieces allow, no wider than `widest` metres.
// Chords leave the arcs by no more than `tolerance`.
Line guided_path(const JunctionPlace& place, const JunctionRoute& route, const LaneEnd& in,
                 const LaneEnd& out, double widest, double tolerance);

// A line of straight pieces with its corners rounded: as wide as the pieces allow, no wider than
// `widest` metres.
Line rounded(const Line& guide, double widest, double tolerance);

}  // namespace streetgen
