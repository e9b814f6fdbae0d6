#include "osm/tag_use.hpp"

#include <algorithm>
#include <set>

#include "streetgen/osm_lanes.hpp"

namespace streetgen {

const std::vector<OsmTagUse>& osm_tag_uses() {
  static const std::vector<OsmTagUse> uses = {
      {"highway", "Class busway: all lanes are bus lanes. Motorways run one way."},
      {"junction", "A roundabout or a circular junction runs one way."},
      {"oneway",
       "The direction of the traffic. All lanes of a reversible or alternating way are for both "
       "directions."},
      {"oneway[:bus|:psv|:bicycle]",
       "Where it is no, a lane at the far kerb of a one-way street runs against the traffic."},
      {"lanes[|:forward|:backward]", "The number of general, bus and carpool lanes."},
      {"lanes[:both_ways|:reversible]", "The number of lanes in the middle, for both directions."},
      {"centre_turn_lane", "Value yes is a lane in the middle, for both directions."},
      {"lanes[:bus|:psv][|:forward|:backward]",
       "So many lanes at the near kerb are bus lanes, unless a list says which."},
      {"turn:lanes[|:forward|:backward]", "The turns that each lane is marked for."},
      {"turn:lanes:both_ways",
       "The number of lanes in the middle, which lead to the left; to the right where one drives on "
       "the left."},
      {"change:lanes[|:forward|:backward]", "Where one may leave each lane."},
      {"width:lanes[|:forward|:backward]", "The width of each lane."},
      {"[access|vehicle|motor_vehicle|motorcar]:lanes[|:forward|:backward]",
       "A lane that is closed to cars is one of those that may drive there: a bus or cycle lane."},
      {"[bus|psv|taxi]:lanes[|:forward|:backward]",
       "A designated lane is a bus lane, as is one that is closed to cars and open to these."},
      {"hov:lanes[|:forward|:backward]", "A designated lane is a carpool lane."},
      {"bicycle:lanes[|:forward|:backward]",
       "A designated lane that is closed to cars, or that tag lanes does not count, is a cycle "
       "lane."},
      {"cycleway:lanes[|:forward|:backward]", "A lane so named is a cycle lane."},
      {"hov", "Value designated: all lanes are carpool lanes."},
      {"[access|vehicle|motor_vehicle|motorcar][|:forward|:backward]",
       "Value no, where buses may drive: all lanes of the direction are bus lanes."},
      {"[bus|psv][|:forward|:backward]",
       "Where cars may not drive, a value that lets buses in makes all lanes bus lanes."},
      {"busway[|:left|:right|:both]",
       "Value lane: a bus lane at the kerb, among the lanes that are counted; opposite_lane: one "
       "against the traffic."},
      {"cycleway[|:left|:right|:both]",
       "Value lane: a cycle lane at the kerb, beside the lanes that are counted; opposite_lane: "
       "one against the traffic. Tracks and shared lanes are no lanes of the roadway."},
      {"cycleway[:left|:right|:both]:oneway",
       "The direction of the cycle lane. One for both directions is made at the far kerb of a "
       "one-way street alone."},
      {"cycleway[|:left|:right|:both]:width", "The width of the cycle lane."},
      {"cycleway[|:left|:right|:both]:lane",
       "Nothing: an advisory lane is a cycle lane as an exclusive one is."},
      {"parking[:left|:right|:both]", "Value lane: a parking lane at the kerb."},
      {"parking:lane[:left|:right|:both]",
       "Values parallel, diagonal, perpendicular and marked: a parking lane at the kerb."},
      {"placement[|:forward|:backward]",
       "The distance from the way to the middle of the roadway, by the lane that the way marks."},
      {"[destination|destination:ref|destination:symbol|destination:colour|destination:street|"
       "destination:country|destination:int_ref|destination:to|destination:ref:to|maxspeed|"
       "minspeed|overtaking|hgv|goods|motorcycle|foot|maxheight|maxweight|maxwidth|surface|"
       "smoothness|stop|traffic_signals]:lanes[|:forward|:backward|:both_ways]",
       "Nothing of lanes: it says neither which there are nor whose."},
  };
  return uses;
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

bool tag_is_told(const std::string& key) {
  static const std::set<std::string> told = [] {
    std::set<std::string> keys;
    for (const OsmTagUse& use : osm_tag_uses()) expand("", use.keys, keys);
    return keys;
  }();
  return told.count(key) > 0;
}

}  // namespace streetgen
