// The place where a lane of a road begins or ends.
#pragma once

#include <cstddef>

#include "streetgen/road_lanes.hpp"

namespace streetgen {

// The lane between two borders of a road at its start, else at its end.
LaneLimit lane_limit(const RoadLanes& road, std::size_t lane, bool at_start);

}  // namespace streetgen
