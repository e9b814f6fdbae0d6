// Cycle and parking lanes at the kerbs, beside the lanes that are counted.
#pragma once

#include "osm/way_lanes.hpp"

namespace streetgen {

// The cycle lanes that tags of one kerb tell of, by the direction in which one rides.
struct CycleWish {
  bool along = false, against = false;
  std::string key{};  // the tag that says so
};
struct CycleWishes {
  CycleWish near, far;
};
CycleWishes wanted_cycle_lanes(WayTags& tags);

// A list that names a cycle lane of the direction means the one at the kerb.
void lay_cycle_lanes(const CycleWishes& wishes, WayLanes& lanes, WayTags& tags);
// Bicycles share a bus lane that no tag tells of.
void name_shared_bus_lanes(const WayLanes& lanes, WayTags& tags);
void lay_parking_lanes(WayLanes& lanes, const OsmLaneUse& use, WayTags& tags);

}  // namespace streetgen
