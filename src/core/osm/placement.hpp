// Where the way lies among its lanes.
#pragma once

#include <optional>

#include "osm/way_lanes.hpp"

namespace streetgen {

// Metres from the way as it is drawn to the middle of all lanes, left positive; none where no tag
// says it.
std::optional<double> placed_offset(const WayLanes& lanes, const OsmLaneUse& use, WayTags& tags);

}  // namespace streetgen
