// Bus lanes that a count or a kerb tells of, where no list does; streets for buses alone.
#pragma once

#include "osm/way_lanes.hpp"

namespace streetgen {

// Wanted bus lanes of one direction, at its near and its far kerb.
struct BusWish {
  int near = 0, far = 0;
  int unplaced = 0;       // of those at the near kerb, of which no tag says that they lie there
  bool by_count = false;  // lanes:psv and its like say how many
  std::string key{};      // the tag that says so
  int lanes() const { return near + far; }
};
struct BusWishes {
  BusWish along, against;
};

// Tags of the kerbs say the sides, and counts the numbers, of the same lanes.
BusWishes wanted_bus_lanes(WayTags& tags);

// `beside`: the lanes that were counted do not include the bus lanes.
void lay_bus_lanes(const BusWish& wish, bool beside, DrivingSide side, HeadingLanes& lanes,
                   WayTags& tags);

// Where buses or carpools alone may drive, all lanes are theirs, unless a list says which.
void give_to_those_alone(HeadingLanes& lanes, WayTags& tags);

}  // namespace streetgen
