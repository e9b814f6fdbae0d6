// The lanes of a way as they are being read, by the direction in which one drives them.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "osm/way_tags.hpp"

namespace streetgen {

// Lanes from left to right in their driving direction.
struct HeadingLanes {
  Heading heading = Heading::along;
  std::vector<OsmLane> lanes;
  bool known = false;     // is their number stated?
  std::size_t listed = 0;  // length of the lists that say the kinds; 0: none does

  bool has(LaneKind kind) const {
    return std::any_of(lanes.begin(), lanes.end(),
                       [&](const OsmLane& lane) { return lane.kind == kind; });
  }
  int driving() const {
    return static_cast<int>(std::count_if(
        lanes.begin(), lanes.end(), [](const OsmLane& lane) { return drives(lane.kind); }));
  }
};

struct WayLanes {
  HeadingLanes along{Heading::along, {}}, against{Heading::against, {}};
  int middle = 0;
  std::optional<int> total;  // what tag lanes counts
  bool shared = false;       // its share of each direction is not stated
  DrivingSide side = DrivingSide::right;
};

// Is the lane at this kerb of its direction the last from left to right?
inline bool lies_last(RoadSide kerb, DrivingSide side) {
  return (kerb == RoadSide::near) == (side == DrivingSide::right);
}

// Puts a lane at the near or far kerb of its direction.
inline void put_at(RoadSide kerb, DrivingSide side, OsmLane lane, std::vector<OsmLane>& lanes) {
  lanes.insert(lies_last(kerb, side) ? lanes.end() : lanes.begin(), std::move(lane));
}

}  // namespace streetgen
