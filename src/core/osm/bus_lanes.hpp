// Bus lanes that a count or a kerb tells of, where no list does; streets for buses alone.
#pragma once

#include "osm/way_lanes.hpp"

namespace streetgen {

// Wanted bus lanes of one direction.
struct BusWish {
  int near = 0, far = 0;
  bool by_count = false;  // lanes:psv and its like, not a tag of the kerb
  std::string key{};      // the tag that says so
  int lanes() const { return near + far; }
};
struct BusWishes {
  BusWish along, against;
};

BusWishes wanted_bus_lanes(WayTags& tags);

// `beside`: the lanes that were counted do not include the bus lanes.
void lay_bus_lanes(const BusWish& wish, bool beside, DrivingSide side, HeadingLanes& lanes,
                   WayTags& tags);

// Where buses may drive and cars may not, all lanes are theirs.
void give_to_buses(HeadingLanes& lanes, WayTags& tags);
// All lanes of a way for carpools are theirs, unless a list says which.
void give_to_carpools(HeadingLanes& lanes, const WayTags& tags);

}  // namespace streetgen
