// Cars on each side of a way: in bays beside the roadway, on the kerb, or nowhere.
#pragma once

#include "osm/way_tags.hpp"

namespace streetgen {

// On the left or right of the way as it is drawn.
OsmSideParking side_parking(const std::string& side, WayTags& tags);

}  // namespace streetgen
