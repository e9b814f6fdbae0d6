// Verges, buffers and cycle tracks between the kerbs of a way and its sidewalks.
#pragma once

#include "osm/way_tags.hpp"

namespace streetgen {

// What tells a cycle track at this kerb of the way; empty: none does.
std::string cycle_track_key(RoadSide kerb, const WayTags& tags);

// Does something that stands on the roadway, or is painted there, part the track from the lanes?
// Such a track is a lane of the roadway.
bool track_is_on_roadway(RoadSide kerb, const WayTags& tags);

// Of one on the roadway: do parked cars part it from the lanes?
bool cars_stand_before_track(RoadSide kerb, const WayTags& tags);

// From the kerb outwards.  What says something of a track that is none is named.
std::vector<SideStrip> side_strips(RoadSide kerb, WayTags& tags);

}  // namespace streetgen
