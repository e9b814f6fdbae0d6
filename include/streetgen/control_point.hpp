// Control points: what tells traffic to wait, or to look out, before or at a junction.
#pragma once

#include <cstdint>
#include <optional>

#include "streetgen/geometry.hpp"

namespace streetgen {

// The strictest first. A mini-roundabout is a node whose island is painted: all that comes yields.
enum class ControlKind { signals, stop, yield, mini_roundabout, pedestrian_crossing };
const char* control_kind_name(ControlKind kind) noexcept;

// A place of an axis.  Signals on the node of a junction speak to all traffic that comes to it,
// unless they have a direction; a stop or yield sign there to the traffic that gives way by rank,
// and with direction `both` to all.  Elsewhere a point speaks to the traffic of its direction: that
// of a one-way street, else that towards the nearer junction.
struct ControlPoint {
  std::int64_t axis_id = 0;
  double abscissa = 0;  // metres along the axis
  ControlKind kind = ControlKind::signals;
  enum class Direction { unknown, along, against, both } direction = Direction::unknown;
};

// Metres.
struct ControlRules {
  double farthest = 50;  // before a junction, within which its control points stand
  double queue = 25;     // of a road between two signals, on which a queue has no room
};

// The kinds of junctions.
enum class JunctionKind {
  ramp,
  fork,
  merge,
  signals,
  stop,
  priority,
  right_before_left,
  roundabout,
  continuation,
  end
};

// By hand: the kind of the node that is nearest to the place among those of the axis.
struct JunctionDecision {
  std::int64_t axis_id = 0;
  Point place;
  JunctionKind kind = JunctionKind::signals;
};

}  // namespace streetgen
