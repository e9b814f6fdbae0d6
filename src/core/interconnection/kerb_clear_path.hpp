// A path about kerbs that the curve between its two lanes would cross.
#pragma once

#include <optional>

#include "interconnection/kerb_obstacle.hpp"
#include "interconnection/movement.hpp"
#include "streetgen/street.hpp"
#include "streetgen/trajectory.hpp"

namespace streetgen {

// The lane beyond its section: at its offset, from `place`, where it ends at `abscissa` of the
// axis, to the node at the start or the end of the axis.  Its share of the roadway stays: half
// widths are linear along the axis.
Line lane_to_node(const Line& axis, const Roadway& roadway, double abscissa, const Point& place,
                  bool to_start);

// A lane at a node: where it ends, from there to the node, and the border line there as for Kerbs.
struct LaneToNode {
  LaneEnd end;
  Line line;
  int border = 0;
};

// The path leaves the lane in and comes upon the lane out as far from the place where they cross,
// or reach the node, as the kerbs allow; tangent to both.  It leaves room for a car beside it, or
// where there is none only stays on the roadway.  None where even a sharp turn crosses a kerb.
std::optional<Trajectory> late_turn(LaneToNode in, LaneToNode out, TrajectoryRule rule,
                                    double tolerance, const Kerbs& kerbs);

}  // namespace streetgen
