// Which lanes of an approach take which of its ways: by what is marked on them, or in order.
#pragma once

#include <vector>

#include "interconnection/way.hpp"

namespace streetgen {

// The turns that are marked on some of the lanes.
unsigned marks_on(const std::vector<LaneEnd>& in, const Group& lanes);

// For each way, from left to right, the lanes of `lanes` that take it.  Each way has goals.
std::vector<Group> served_lanes(const std::vector<LaneEnd>& in, const Group& lanes,
                                const Ways& ways);

}  // namespace streetgen
