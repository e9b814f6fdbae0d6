// The lanes of a road across its reference line: where each border lies, as OpenDRIVE has it.
#pragma once

#include <vector>

#include "streetgen/plan_view.hpp"

namespace streetgen {

// The part of a ground that is a lane.
enum class LanePart { whole, left_half, right_half };

struct LaneGround {
  MultiPolygon surface;  // empty: so wide about the line
  Line line;             // its middle, in the direction of the road
  // Metres; 0: the lane lies on its surface alone, and has no width where that is not.
  double width = 0;
  LanePart part = LanePart::whole;
};

// The place where a lane begins or ends.
struct LaneLimit {
  ChainPlace middle;  // in the direction of the road
  double width = 0;   // metres
};

struct RoadLanes {
  std::vector<PlanPiece> chain;
  // Metres along the chain from 0 to its end.  Borders are straight from one to the next.
  std::vector<double> stations;
  // By border, from the left of the first lane to the right of the last, then by station: metres to
  // the left of the chain.
  std::vector<std::vector<double>> borders;
  std::vector<LaneLimit> starts, ends;  // by lane
};

// The lanes of a road, given from the left to the right, across the chain of lines and arcs that
// follows `axis` by `tolerance` metres, with arcs as wide as half the road where there is room.  Of
// two that leave a gap or overlap, the border is in the middle.  None is narrower than a
// millimetre. An axis without length, or no lane: no station.
RoadLanes road_lanes(const Line& axis, const std::vector<LaneGround>& lanes, double tolerance);

// The same across a chain that is known.
RoadLanes road_lanes(std::vector<PlanPiece> chain, const std::vector<LaneGround>& lanes);

// The part of a road between two stations, `from` before `to`, counted from its own beginning.
// Beside the chain there is none: no station.
RoadLanes road_part(const RoadLanes& road, double from, double to);

}  // namespace streetgen
