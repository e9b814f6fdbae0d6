#include "osm/tag_use.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace streetgen {

// Words that several tags may have.
constexpr const char* who_may =
    "yes no none designated official permissive private permit destination customers customer "
    "delivery loading residents resident employees restricted agricultural forestry emergency "
    "military construction discouraged use_sidepath dismount unknown public closed local "
    "bus psv taxi hov carpool bicycle cycle foot";
constexpr const char* yes_or_no = "yes no true false 1 0 -1";
constexpr const char* cycleways =
    "lane opposite_lane track opposite_track opposite shared_lane share_busway "
    "opposite_share_busway shared shoulder separate sidepath sidewalk crossing asl soft_lane "
    "yes no none";

const std::vector<OsmTagUse>& osm_tag_uses() {
  static const std::string of_lane = std::string(who_may) + " lane";
  static const char* const who_may_on_lane = of_lane.c_str();
  static const std::vector<OsmTagUse> uses = {
      {"highway",
       "Class busway: all lanes are bus lanes. Motorways run one way, unless oneway or "
       "lanes:backward says otherwise."},
      {"junction", "A roundabout or a circular junction runs one way.", nullptr,
       "roundabout circular"},
      {"oneway",
       "The direction of the traffic. All lanes of a reversible or alternating way are for both "
       "directions."},
      {"oneway[:bus|:psv|:bicycle]",
       "Where it is no, a lane at the far kerb of a one-way street runs against the traffic.",
       yes_or_no},
      {"lanes[|:forward|:backward]", "The number of general, bus and carpool lanes."},
      {"lanes[:both_ways|:reversible]", "The number of lanes in the middle, for both directions."},
      {"centre_turn_lane", "Value yes is a lane in the middle, for both directions.", "yes no"},
      {"lanes[:bus|:psv][|:forward|:backward]",
       "So many lanes are bus lanes, where a list or tag busway says, else at the near kerb, and "
       "that is named. So is a number less than the bus lanes at the kerbs."},
      {"turn:lanes[|:forward|:backward]", "The turns that each lane is marked for."},
      {"turn[|:forward|:backward]",
       "The turns that all lanes of the direction are marked for, where no list marks any."},
      {"turn:lanes:both_ways",
       "The number of lanes in the middle, which lead to the left, and to the right where one "
       "drives on the left. Another turn is named."},
      {"change:lanes[|:forward|:backward]", "Where one may leave each lane."},
      {"width:lanes[|:forward|:backward]",
       "The width of each lane: 1.5 to 8 m, of a cycle lane 0.5 to 4 m."},
      {"[access|vehicle|motor_vehicle|motorcar]:lanes[|:forward|:backward]",
       "A lane that is closed to cars is one of those that may drive there: a bus or cycle lane. "
       "Where nothing lets anybody in, it is a closed lane, and is named. A lane for cars that end "
       "there is open to all, and is named.",
       who_may},
      {"[bus|psv|taxi]:lanes[|:forward|:backward]",
       "A lane with value designated or lane is a bus lane, as is one that is closed to cars and "
       "open to these. On a way that is closed to cars all lanes are bus lanes.",
       who_may_on_lane},
      {"hov:lanes[|:forward|:backward]", "A lane with value designated or lane is a carpool lane.",
       who_may_on_lane},
      {"bicycle:lanes[|:forward|:backward]",
       "A designated lane that is closed to cars, or that tag lanes does not count, is a cycle "
       "lane, as is one with value lane.",
       who_may_on_lane},
      {"cycleway:lanes[|:forward|:backward]", "A lane so named is a cycle lane.",
       "lane exclusive advisory designated soft_lane shared_lane pictogram track yes no none"},
      {"hov[|:forward|:backward]",
       "Value designated: all lanes of the direction are carpool lanes, unless a list says "
       "which. Value lane says of no lane which it is, and is named.",
       who_may},
      {"[access|vehicle|motor_vehicle|motorcar][|:forward|:backward]",
       "Values such as no and private, where buses may drive: all lanes of the direction are bus "
       "lanes.",
       who_may},
      {"[bus|psv|taxi][|:forward|:backward]",
       "Where cars may not drive, a value that lets buses in makes all lanes bus lanes. Where "
       "cars may drive to a destination, it is named.",
       who_may},
      {"busway[|:left|:right|:both]",
       "Value lane: a bus lane at the kerb, among the lanes that are counted, unless all of them "
       "are bus lanes; opposite_lane: one against the traffic, at the far kerb. At another kerb, "
       "or on a street of both directions, it is named.",
       "lane opposite_lane opposite separate no none"},
      {"cycleway[|:left|:right|:both]",
       "Value lane or soft_lane: a cycle lane at the kerb, beside the lanes that are counted; "
       "opposite_lane: one against the traffic. track: a strip between kerb and sidewalk, columns "
       "strips_left and _right, or a lane where its separation stands on the roadway. Shared lanes "
       "are no lanes of the roadway. share_busway and opposite_share_busway without a bus lane are "
       "named.",
       cycleways},
      {"cycleway[:left|:right|:both]:oneway",
       "The direction of the cycle lane. One for both directions is made at the far kerb of a "
       "one-way street alone.",
       yes_or_no},
      {"cycleway[|:left|:right|:both]:[width|est_width]",
       "The width of the cycle lane, 0.5 to 4 m, or of the track; est_width where width is none. "
       "Without a cycle lane or track it is named."},
      {"cycleway[|:left|:right|:both]:separation[|:left|:right|:both]",
       "What parts a track from the lanes. Paint, posts, planters and parked cars stand on the "
       "roadway, and the track is a lane of it: behind a parking lane where parking_lane is said. "
       "Grass, trees, hedges, ditches and greenery are a verge between the kerb and the track, or "
       "with the side of the track between it and the sidewalk.",
       "solid_line dashed_line double_solid_line barred_area surface bump studs flex_post "
       "vertical_panel cone bollard planter jersey_barrier parking_lane separation_kerb "
       "grass_verge "
       "tree_row hedge ditch greenery kerb fence railing guard_rail structure yes no none"},
      {"cycleway[|:left|:right|:both]:buffer[|:left|:right|:both]",
       "The strip between the kerb and the track, or with the side of the track between it and the "
       "sidewalk: yes or metres. Without a track behind a kerb it is named."},
      {"verge[|:left|:right|:both]",
       "A verge between kerb and sidewalk, or kerb and track: columns strips_left and _right.",
       "left right both yes no none separate grass"},
      {"verge[|:left|:right|:both]:width", "The width of the verge in metres, up to 19.5."},
      {"cycleway[|:left|:right|:both]:lane",
       "Nothing: an advisory lane is a cycle lane as an exclusive one is. Without a cycle lane "
       "the way is named.",
       "advisory exclusive mandatory pictogram soft_lane"},
      {"parking[:left|:right|:both]",
       "Value lane: a parking lane at the kerb. street_side, half_on_kerb and on_kerb: column "
       "parking_left or parking_right, of which bays are made beside the roadway. no: rules place "
       "no bays there. separate and shoulder make none, and are named.",
       "lane street_side on_kerb half_on_kerb shoulder separate yes no none"},
      {"parking:lane[:left|:right|:both]",
       "Values parallel, diagonal, perpendicular and marked: a parking lane at the kerb, so deep. "
       "no, none, no_parking, no_stopping, no_standing and fire_lane: rules place no bays there.",
       "parallel diagonal perpendicular marked yes no none no_parking no_stopping no_standing "
       "separate fire_lane"},
      {"parking:lane[:left|:right|:both]:[parallel|diagonal|perpendicular|marked]",
       "Where cars that stand so do: on_street, lane and painted_area_only, also among others, are "
       "on a parking lane; half_on_kerb, on_kerb, street_side and lay_by are as of parking.",
       "on_street lane painted_area_only on_kerb half_on_kerb shoulder street_side lay_by"},
      {"parking[:left|:right|:both]:width",
       "The width of the parking lane or the depth of the bays, 1 to 7 m. Where no tag says where "
       "cars stand, it is named."},
      {"parking[:left|:right|:both]:capacity",
       "At most so many bays lie on the side, up to 1000; of both sides each has so many."},
      {"parking[:left|:right|:both]:orientation",
       "How bays lie, and the depth of a parking lane without a width: by settings diagonal 4.5 m, "
       "perpendicular 5 m; less where the stated width of the street is too small for the lanes "
       "beside it, and that is named. Of several values the deepest counts, and is named.",
       "parallel diagonal perpendicular"},
      {"bus_bay", "Nothing: buses stop in a bay that lanes do not count, and the way is named.",
       "left right both yes no none"},
      {"cycleway[|:left|:right|:both]:surface",
       "What cycle lanes are paved with, columns cycle_paved_left and _right."},
      {"minor_lanes[|:forward|:backward]",
       "Nothing: these are none of the lanes that are counted, and the way is named."},
      {"shoulder[|:left|:right|:both]",
       "Nothing: a shoulder is what lanes leave of the stated width of a street. Where there is "
       "one, the way is named.",
       "left right both yes no none"},
      {"shoulder[|:left|:right|:both]:width", "Nothing: no lane is made of a shoulder."},
      {"lane_markings", "Value no: nothing is painted on the lanes, column lane_markings."},
      {"placement[|:forward|:backward]",
       "The distance from the way to the middle of the roadway, by the lane that the way marks."},
      {"[destination|destination:ref|destination:symbol|destination:colour|destination:street|"
       "destination:country|destination:int_ref|destination:to|destination:ref:to|"
       "minspeed|overtaking|hgv|goods|motorcycle|foot|maxheight|maxweight|maxwidth|surface|"
       "smoothness|stop|traffic_signals]:lanes[|:forward|:backward|:both_ways]",
       "Nothing of lanes: it says neither which there are nor whose."},
  };
  return uses;
}

const std::vector<OsmTagUse>& osm_way_tag_uses() {
  static const std::vector<OsmTagUse> uses = {
      {"width:carriageway, width, est_width",
       "The width of the roadway from kerb to kerb: the first of them that is a length."},
      {"maxspeed[|:forward|:backward], zone:maxspeed, source:maxspeed, maxspeed:type",
       "The speed: of the way, else the highest of its directions, else of its lanes, else that "
       "of its zone."},
      {"maxspeed:lanes[|:forward|:backward]",
       "The speed where neither the way nor a direction has one: the highest. A word that is no "
       "speed is named."},
      {"[access|vehicle|motor_vehicle|motorcar][|:forward|:backward]",
       "Who may drive, column access: the tag nearest to cars counts, and of one tag that of the"
       " direction."},
      {"[bus|psv|taxi|hov|bicycle][|:forward|:backward]",
       "Who alone may drive where cars may not: buses with taxis, carpools or bicycles."},
      {"maxheight",
       "The height of vehicles that may pass, column height_limit. none, default and words for a "
       "missing sign are no height."},
      {"layer",
       "The level, from -10 to 10. A bridge on layer 0 or none is on level 1, a tunnel on level "
       "-1; where they contradict it, it stands, and the way is named."},
      {"bridge", "Level 1 where layer says 0 or none."},
      {"tunnel", "Level -1 where layer says 0 or none; building_passage is on the ground.", nullptr,
       "building_passage"},
      {"name", "The name of the street."},
      {"ref", "The number of the route."},
      {"area", "A way with value yes is no street, and is named."},
      {"aeroway", "The class, where there is no highway."},
      {"sidewalk[|:left|:right|:both]",
       "Whether there are sidewalks; separate: a line of its own is the sidewalk, column "
       "sidewalk_apart."},
      {"sidewalk[|:left|:right|:both]:width", "The widths of the sidewalks."},
      {"surface", "What the roadway is paved with, column paved."},
      {"sidewalk[|:left|:right|:both]:surface",
       "What the sidewalks are paved with, columns sidewalk_paved_left and _right."},
  };
  return uses;
}

std::vector<std::string> parted(const std::string& text, const std::string& mark) {
  std::vector<std::string> parts;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(mark, from), text.size());
    parts.push_back(text.substr(from, to - from));
    from = to + mark.size();
  }
  return parts;
}

namespace {

// All keys of a pattern with alternatives in brackets.
void expand(const std::string& start, const std::string& rest, std::set<std::string>& keys) {
  const std::size_t open = rest.find('[');
  if (open == std::string::npos) {
    keys.insert(start + rest);
    return;
  }
  const std::size_t close = rest.find(']', open);
  for (std::size_t from = open + 1; from <= close;) {
    const std::size_t to = std::min(rest.find('|', from), close);
    expand(start + rest.substr(0, open) + rest.substr(from, to - from), rest.substr(close + 1),
           keys);
    from = to + 1;
  }
}

}  // namespace

const std::map<std::string, const OsmTagUse*>& told_keys() {
  static const std::map<std::string, const OsmTagUse*> told = [] {
    std::map<std::string, const OsmTagUse*> uses;
    for (const auto* some : {&osm_tag_uses(), &osm_way_tag_uses()})
      for (const OsmTagUse& use : *some) {
        std::set<std::string> keys;
        for (const std::string& pattern : parted(use.keys, ", ")) expand("", pattern, keys);
        for (const std::string& key : keys) uses.emplace(key, &use);
      }
    return uses;
  }();
  return told;
}

bool tag_is_told(const std::string& key) { return told_keys().count(key) > 0; }

}  // namespace streetgen
