// The shortest way between two lanes past the kerbs of a junction, its corners rounded.
#pragma once

#include <optional>

#include "interconnection/kerb_obstacle.hpp"
#include "interconnection/movement.hpp"
#include "streetgen/junction_movement.hpp"

namespace streetgen {

// From the end of a lane to the start of another, tangent to both, clear of the kerbs and drivable;
// none: there is no such.  It goes against the traffic of an edge inside `place` only where that
// saves far.
// from, to: the places of the two lanes' border lines in the list that the kerbs were made of.
// Chords leave the arcs by no more than `tolerance`.
std::optional<Line> taut_path(const JunctionPlace& place, const Kerbs& kerbs, int from, int to,
                              const LaneEnd& in, const LaneEnd& out, double tolerance);

}  // namespace streetgen
