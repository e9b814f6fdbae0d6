// The lanes that the tags of a way of OpenStreetMap state.
//
// Tag `lanes` counts lanes for motor traffic, lists such as turn:lanes count all lanes: a reading
// fits both.  Where none does, the longest one wins, and the tag is named.  No tag is lost in
// silence: what states lanes and is not made stands in `unread`, each with its reason.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "streetgen/lane.hpp"

namespace streetgen {

using OsmTags = std::map<std::string, std::string>;  // highway is the class of the way

struct OsmLane {
  LaneKind kind = LaneKind::general;
  bool listed = true;             // lists of lanes count it; lanes of kerbs lie beside these
  std::string turn{}, change{};   // words of OSM's lists; empty: nothing is said
  std::optional<double> width{};  // metres
  bool width_usual = false;       // no tag states the width: cars that stand so need it
};

// Cars that stand on one side of a way off its lanes, or the number of those on its lane.
struct OsmSideParking {
  std::string place{};  // street_side, half_on_kerb, on_kerb, lane, no; empty: nothing is said
  std::string orientation{};      // parallel, diagonal, perpendicular; empty: nothing is said
  std::optional<double> depth{};  // metres across the street
  std::optional<int> capacity{};  // cars
};

// A strip between the kerb and the sidewalk of one side of a way.
enum class SideStripKind { verge, buffer, cycle_track, two_way_cycle_track };
struct SideStrip {
  SideStripKind kind = SideStripKind::verge;
  std::optional<double> width{};  // metres; none: nothing is said
};
// The word of columns strips_left and strips_right of an axis.
const char* side_strip_name(SideStripKind kind);

// What the reader takes from elsewhere.
struct OsmLaneUse {
  DrivingSide driving_side = DrivingSide::right;
  double lane_width = 3.5, cycle_lane_width = 1.5, parking_lane_width = 2;  // metres, where unknown
  double narrowest_of_several = 2.625;    // metres, where a width alone makes several lanes
  std::optional<double> roadway_width{};  // metres, stated
  int usual_lanes = 1;                    // of a way of its width of which no lanes are stated
  // Metres from the kerb to the end of a car that stands askew or across.
  double diagonal_depth = 4.5, perpendicular_depth = 5;
  double two_way_width = 4.5;  // metres; a street of both directions has one lane on less
};

struct UnreadTag {
  std::string key, reason;
};

enum class WayDirection { both, direct, reverse };

struct OsmLanes {
  WayDirection direction = WayDirection::both;
  // Each list from left to right in its driving direction.
  std::vector<OsmLane> forward{}, backward{};
  int both_ways = 0;  // in the middle, for both directions
  // Are general and bus lanes of the direction stated, or only usual?
  bool forward_known = false, backward_known = false;
  // The words of column access of an axis say who may drive; empty: all may.
  std::string access_forward{}, access_backward{};
  std::optional<int> lane_count{};  // stated lanes for motor traffic, of all directions
  // Metres from the way to the middle of all lanes, left positive.
  std::optional<double> roadway_offset{};
  OsmSideParking parking_left{}, parking_right{};        // of the way as it is drawn
  std::vector<SideStrip> strips_left{}, strips_right{};  // likewise, each from the kerb outwards
  std::vector<UnreadTag> unread{};
};

OsmLanes read_osm_lanes(const OsmTags& tags, const OsmLaneUse& use);

// The word of column access of an axis that a word of a source means, in any case; empty: all may
// drive, ?: it means nothing.
const char* access_word(const std::string& said);

// What becomes of a tag.  Alternatives of the key stand in brackets:
// turn:lanes[:forward|:backward].
struct OsmTagUse {
  const char* keys;
  const char* becomes;
  // Words that it, or each lane of a list, may have, parted by spaces; null: a number, or what the
  // reader judges by itself.
  const char* words = nullptr;
  // Words among others that mean something, of which one that is misspelt is told.
  const char* meant = nullptr;
};
const std::vector<OsmTagUse>& osm_tag_uses();
// Tags of a way that do not speak of its lanes.
const std::vector<OsmTagUse>& osm_way_tag_uses();

}  // namespace streetgen
