// How many lanes each direction has, and of which kinds, by tag lanes and by lists.
#pragma once

#include "osm/bus_lanes.hpp"
#include "osm/kerb_lanes.hpp"
#include "osm/lane_list.hpp"
#include "osm/way_lanes.hpp"

namespace streetgen {

// The lanes of a way without those of its kerbs.  A direction of unknown lanes has its usual ones:
// one of a two-way street, else use.usual_lanes.
WayLanes counted_lanes(const LaneLists& along, const LaneLists& against,
                       const CycleWishes& cycles, const OsmLaneUse& use, WayTags& tags);

}  // namespace streetgen
