// The lanes that tags state, as a line of text.
#pragma once

#include <string>
#include <vector>

#include "streetgen/osm_lanes.hpp"

namespace streetgen {
namespace osm_lanes_test {

inline const char* letter(LaneKind kind) {
  switch (kind) {
    case LaneKind::bus:
      return "bus";
    case LaneKind::carpool:
      return "carpool";
    case LaneKind::cycle:
      return "cycle";
    case LaneKind::parking:
      return "parking";
    case LaneKind::closed:
      return "closed";
    default:
      return "general";
  }
}

inline std::string list_of(const std::vector<OsmLane>& lanes) {
  std::string text;
  for (const OsmLane& lane : lanes) {
    text += (text.empty() ? "" : " ") + std::string(letter(lane.kind));
    if (!lane.turn.empty()) text += ":" + lane.turn;
    if (!lane.change.empty()) text += "/" + lane.change;
    if (lane.width) text += "=" + std::to_string(*lane.width).substr(0, 4);
  }
  return text;
}

// Lanes of both directions, then those in the middle, then what was not read.
inline std::string read(const OsmTags& tags, OsmLaneUse use = {}) {
  const OsmLanes lanes = read_osm_lanes(tags, use);
  std::string text = list_of(lanes.forward) + " | " + list_of(lanes.backward);
  if (lanes.both_ways > 0) text += " | " + std::to_string(lanes.both_ways);
  for (const UnreadTag& tag : lanes.unread) text += " ?" + tag.key;
  return text;
}

inline OsmLaneUse left_hand() {
  OsmLaneUse use;
  use.driving_side = DrivingSide::left;
  return use;
}

}  // namespace osm_lanes_test
}  // namespace streetgen
