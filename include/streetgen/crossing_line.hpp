// Paint on a lane that a pedestrian crossing is in the way of lies before it, as the driver comes.
#pragma once

#include <optional>
#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

// A lane as it is driven.
struct DrivenLane {
  Line way;                        // in driving direction, with two distinct points
  double width = 0;                // metres
  bool between_junctions = false;  // not the junction ahead alone, the end behind is one too
};

struct PaintOnLane {
  Line line;  // of a line across the lane, or of an arrow from foot to tip
  bool arrow = false;
  bool stays = false;  // a line that lies where it lies, before a ring
};

struct CrossingRules {
  double ahead = 1;    // metres from a line to the crossing behind it
  double of_arm = 15;  // metres from the end of the lane to a crossing that is one of the arm
};

// Paint that moves is turned about the origin, then shifted.
struct Slide {
  double cosine = 1, sine = 0;
  Point shift;
};

struct LaidPaint {
  std::optional<Slide> slide{};  // none: it lies where it lay
  bool has_room = true;          // else it is not painted; it lies where the lane begins
};

// Crossings of an arm are those near to the end of the lane, and those before them that leave no
// car room between two; one nearer to a junction behind belongs to that one, unless it leaves no car
// room, or the line none before another.  Lines lie before the crossing of the arm that the driver
// meets first, arrows before the line, and on no crossing.  `crossings`: their grounds, of which
// those beside the lane do nothing.
// In the order of the paint.
std::vector<LaidPaint> lay_before_crossings(const DrivenLane& lane,
                                            const std::vector<MultiPolygon>& crossings,
                                            const std::vector<PaintOnLane>& paint,
                                            const CrossingRules& rules);

}  // namespace streetgen
