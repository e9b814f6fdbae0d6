#include "streetgen/osm_lanes.hpp"

#include <algorithm>
#include <cmath>

#include "osm/bus_lanes.hpp"
#include "osm/kerb_lanes.hpp"
#include "osm/lane_count.hpp"
#include "osm/lane_list.hpp"
#include "osm/placement.hpp"
#include "osm/side_parking.hpp"
#include "osm/side_strips.hpp"
#include "osm/way_access.hpp"
#include "osm/way_tags.hpp"

namespace streetgen {

namespace {

constexpr std::size_t most_lanes = 30;  // of all directions, with those of the kerbs
constexpr double width_rounded = 0.25;  // metres, within which widths of a lane are alike
constexpr int most_each_way = 10;       // that a width alone makes
constexpr std::size_t most_marks = 10;  // on one lane

bool is_one_of(const std::string& word, std::initializer_list<const char*> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// The marks of a lane, parted by ;, without empty ones between them; none where a word is no mark.
std::optional<std::string> marks_of(const std::string& words) {
  std::string marks;
  std::size_t count = 0;
  for (std::size_t from = 0; from <= words.size();) {
    const std::size_t to = std::min(words.find(';', from), words.size());
    const std::string word = words.substr(from, to - from);
    from = to + 1;
    if (word.empty()) continue;
    if (++count > most_marks ||
        !is_one_of(word, {"none", "reverse", "sharp_left", "left", "slight_left", "merge_to_left",
                          "through", "merge_to_right", "slight_right", "right", "sharp_right"}))
      return std::nullopt;
    marks += (marks.empty() ? "" : ";") + word;
  }
  return marks;
}

bool is_change(const std::string& word) {
  return is_one_of(word, {"", "yes", "no", "not_left", "not_right", "only_left", "only_right"});
}

// The lanes that a list of so many words speaks of; empty: none.
std::vector<OsmLane*> lanes_of_list(std::size_t words, std::vector<OsmLane>& lanes) {
  const auto those = [&](const auto& counts) {
    std::vector<OsmLane*> found;
    for (OsmLane& lane : lanes)
      if (counts(lane)) found.push_back(&lane);
    return found.size() == words ? found : std::vector<OsmLane*>{};
  };
  std::vector<OsmLane*> found = those([](const OsmLane& lane) { return lane.listed; });
  if (found.empty()) found = those([](const OsmLane& lane) { return drives(lane.kind); });
  if (found.empty())
    found = those([](const OsmLane& lane) { return lane.kind != LaneKind::parking; });
  return found;
}

// Words that say of no lane what another lane is not.
bool says_nothing(const LaneLists::List& list) {
  return std::all_of(list.words.begin(), list.words.end(), [](const std::string& word) {
    return word.empty() || word == "yes" || word == "none";
  });
}

void take_lists(const LaneLists& lists, HeadingLanes& lanes, WayTags& tags) {
  for (const LaneLists::List& list : lists.all()) {
    const std::string name = list.key.substr(0, list.key.find(':'));
    const std::vector<OsmLane*> named = lanes_of_list(list.words.size(), lanes.lanes);
    const bool of_who = !is_one_of(name, {"turn", "change", "width"});
    if (of_who ? list.words.size() != lanes.listed && !says_nothing(list) : named.empty()) {
      tags.name(list.key, "it lists " + std::to_string(list.words.size()) +
                              " lanes, and there are " + std::to_string(lanes.lanes.size()));
      continue;
    }
    if (of_who) continue;
    const auto known = [&](const std::string& word, LaneKind kind) {
      return name == "turn"     ? marks_of(word).has_value()
             : name == "change" ? is_change(word)
                                : word.empty() || lane_width_of(word, kind).has_value();
    };
    for (std::size_t i = 0; i < named.size(); ++i) {
      OsmLane& lane = *named[i];
      // A word that means nothing is lost alone: those beside it keep their places.
      if (!known(list.words[i], lane.kind))
        tags.name(list.key, means_nothing(list.words[i]));
      else if (name == "turn")
        lane.turn = *marks_of(list.words[i]);
      else if (name == "change")
        lane.change = list.words[i];
      else if (!list.words[i].empty())
        lane.width = lane_width_of(list.words[i], lane.kind);
    }
  }
}

// A mark of a whole direction is that of each of its lanes, unless a list marks them.
void take_marks(HeadingLanes& lanes, WayTags& tags) {
  const std::string key = tags.said_of("turn", lanes.heading), said = tags.value(key);
  if (said.empty()) return;
  const std::optional<std::string> marks = marks_of(said);
  if (!marks) return tags.name(key, means_nothing(said));
  if (!lanes.known) return tags.name(key, "nothing says how many lanes are so marked");
  if (std::any_of(lanes.lanes.begin(), lanes.lanes.end(),
                  [](const OsmLane& lane) { return !lane.turn.empty(); }))
    return;
  for (OsmLane& lane : lanes.lanes)
    if (drives(lane.kind)) lane.turn = *marks;
}

double usual_width(const OsmLane& lane, const OsmLaneUse& use) {
  return lane.width.value_or(lane.kind == LaneKind::cycle     ? use.cycle_lane_width
                             : lane.kind == LaneKind::parking ? use.parking_lane_width
                                                              : use.lane_width);
}

// Lanes of motor traffic that have room in so many metres, as the street has in its width.
int lanes_in(double room, const OsmLaneUse& use) {
  const int usual = static_cast<int>(std::lround(room * use.usual_lanes / *use.roadway_width));
  const int most = static_cast<int>(room / use.narrowest_of_several);
  return std::max(std::min({usual, most, most_each_way}), 1);
}

// Takes general lanes away, or adds some, but for the last.
void make_driving(int count, HeadingLanes& lanes) {
  const auto is_general = [](const OsmLane& lane) { return lane.kind == LaneKind::general; };
  while (lanes.driving() != count) {
    const auto general = std::find_if(lanes.lanes.begin(), lanes.lanes.end(), is_general);
    if (general == lanes.lanes.end()) return;
    if (lanes.driving() < count)
      lanes.lanes.insert(general, OsmLane{});
    else if (std::count_if(lanes.lanes.begin(), lanes.lanes.end(), is_general) > 1)
      lanes.lanes.erase(general);
    else
      return;
  }
}

// Beside the lanes of the kerbs the street is too narrow for two lanes.
void share_one_lane(WayLanes& lanes) {
  const auto is_general = [](const OsmLane& lane) { return lane.kind == LaneKind::general; };
  for (const HeadingLanes* of_heading : {&lanes.along, &lanes.against})
    if (lanes.middle > 0 || of_heading->driving() != 1 ||
        std::none_of(of_heading->lanes.begin(), of_heading->lanes.end(), is_general))
      return;
  for (HeadingLanes* of_heading : {&lanes.along, &lanes.against}) {
    auto& some = of_heading->lanes;
    some.erase(std::remove_if(some.begin(), some.end(), is_general), some.end());
  }
  lanes.middle = 1;
  lanes.total = 1;  // so that nothing counts lanes by the whole width
}

// Unknown lanes are as many as the width of the street has room for beside the lanes of the kerbs,
// and those against the traffic of a one-way street.  Of two directions both have as many.
void fill_width(WayLanes& lanes, const OsmLaneUse& use, const WayTags& tags) {
  const bool known = lanes.along.known || (!tags.one_way() && lanes.against.known);
  if (tags.takes_turns() || known || !use.roadway_width) return;
  double room = *use.roadway_width;
  for (const HeadingLanes* of_heading : {&lanes.along, &lanes.against})
    for (const OsmLane& lane : of_heading->lanes)
      if (!drives(lane.kind) || (tags.one_way() && of_heading == &lanes.against))
        room -= usual_width(lane, use);
  if (tags.one_way()) return make_driving(lanes_in(room, use), lanes.along);
  if (room < *use.roadway_width && room < use.two_way_width) return share_one_lane(lanes);
  for (HeadingLanes* of_heading : {&lanes.along, &lanes.against})
    make_driving(std::max(lanes_in(room / 2, use), of_heading->driving()), *of_heading);
}

// Cars that stand across the street have what lanes of least width leave, or a lane as along it.
void leave_lanes(WayLanes& lanes, const OsmLaneUse& use, WayTags& tags) {
  if (!use.roadway_width) return;
  const double least = use.narrowest_of_several;
  double taken = lanes.middle * least, wanted = 0;
  std::vector<OsmLane*> across;
  for (HeadingLanes* of_heading : {&lanes.along, &lanes.against})
    for (OsmLane& lane : of_heading->lanes) {
      const double own = drives(lane.kind) ? lane.width.value_or(least) : usual_width(lane, use);
      (lane.width_usual ? wanted : taken) += own;
      if (lane.width_usual) across.push_back(&lane);
    }
  if (across.empty() || taken + wanted <= *use.roadway_width) return;
  const double share = (*use.roadway_width - taken) / wanted;
  for (OsmLane* lane : across) lane->width = std::max(*lane->width * share, use.parking_lane_width);
  tags.name_first_of({"width:carriageway", "width", "est_width"},
                     "it leaves too little for cars that stand across the street");
}

// Of a two-way street a list without a direction speaks of no lane, but one of buses of a street
// that is theirs.
void name_lists_of_both(const OsmTags& said, const WayLanes& lanes, WayTags& tags) {
  if (tags.one_way()) return;
  const bool for_buses = lanes.along.has(LaneKind::bus) && !lanes.along.has(LaneKind::general) &&
                         !lanes.against.has(LaneKind::general);
  for (const char* name : {"turn", "change", "width", "access", "vehicle", "motor_vehicle",
                           "motorcar", "bus", "psv", "taxi", "hov", "bicycle", "cycleway"})
    if (const std::string key = std::string(name) + ":lanes";
        said.count(key) > 0 && !speaks_of_each_direction(tags.value(key), tags) &&
        !(for_buses && is_one_of(name, {"bus", "psv", "taxi"})))
      tags.name(key, "it says no direction of a street of both");
  if (!tags.value("turn").empty()) tags.name("turn", "it says no direction of a street of both");
}

// Buses that may drive against the traffic have a lane for that, or share one.
void name_buses_without_lane(const WayLanes& lanes, WayTags& tags) {
  if (!tags.one_way() || !lanes.against.lanes.empty()) return;
  for (const char* key : {"oneway:bus", "oneway:psv"})
    if (tags.value(key) == "no") tags.name(key, "no lane against the traffic is stated");
}

// Widths of all lanes that the street has no room for: its lanes become narrower alike.
void name_widths_beyond_street(const WayLanes& lanes, const OsmLaneUse& use, WayTags& tags) {
  double sum = 0, rounded = 0;
  for (const HeadingLanes* of_heading : {&lanes.along, &lanes.against})
    for (const OsmLane& lane : of_heading->lanes) {
      if (!lane.width) return;
      sum += *lane.width;
      rounded += width_rounded;
    }
  if (lanes.middle > 0 || !use.roadway_width || sum <= *use.roadway_width + rounded) return;
  tags.name_first_of({"width:lanes", "width:lanes:forward", "width:lanes:backward"},
                     "the lanes are wider together than the street, and become narrower");
}

// Bays of buses, shoulders and lanes that are not counted, of which nothing is made.
void name_what_is_beside(WayTags& tags) {
  const auto name_each = [&](const std::string& base, std::initializer_list<const char*> ends,
                             const std::string& reason) {
    for (const char* end : ends)
      if (const std::string said = tags.value(base + end);
          !said.empty() && !is_one_of(said, {"no", "none", "0"}))
        tags.name(base + end, reason);
  };
  name_each("bus_bay", {""}, "no bay is made for buses");
  name_each("minor_lanes", {"", ":forward", ":backward"}, "these lanes are not made");
  name_each("shoulder", {"", ":left", ":right", ":both"}, "no lane is made of a shoulder");
}

}  // namespace

OsmLanes read_osm_lanes(const OsmTags& said, const OsmLaneUse& use) {
  WayTags tags(said, use.driving_side);
  const LaneLists along(tags, Heading::along), against(tags, Heading::against);
  const CycleWishes cycles = wanted_cycle_lanes(tags);
  WayLanes lanes = counted_lanes(along, against, cycles, use, tags);
  lay_cycle_lanes(cycles, lanes, tags);
  lay_parking_lanes(lanes, use, tags);
  fill_width(lanes, use, tags);
  leave_lanes(lanes, use, tags);
  for (HeadingLanes* of_heading : {&lanes.along, &lanes.against})
    give_to_those_alone(*of_heading, tags);
  name_shared_bus_lanes(lanes, tags);
  if (!tags.takes_turns()) {
    take_lists(along, lanes.along, tags);
    if (!lanes.against.lanes.empty()) take_lists(against, lanes.against, tags);
    take_marks(lanes.along, tags);
    take_marks(lanes.against, tags);
  }
  name_lists_of_both(said, lanes, tags);
  name_buses_without_lane(lanes, tags);
  name_what_is_beside(tags);
  name_widths_beyond_street(lanes, use, tags);

  OsmLanes read;
  read.direction = tags.direction();
  read.parking_left = side_parking("left", tags);
  read.parking_right = side_parking("right", tags);
  for (const RoadSide kerb : {RoadSide::near, RoadSide::far})
    (tags.key_of("", kerb) == ":left" ? read.strips_left : read.strips_right) =
        side_strips(kerb, tags);
  const Access along_access = way_access(Heading::along, tags),
               against_access = tags.one_way() && lanes.against.lanes.empty()
                                    ? along_access
                                    : way_access(Heading::against, tags);
  const bool turned = tags.drawn_against();
  read.access_forward = access_name(turned ? against_access : along_access);
  read.access_backward = access_name(turned ? along_access : against_access);
  if (lanes.along.lanes.size() + lanes.against.lanes.size() + lanes.middle > most_lanes) {
    for (const auto& [key, word] : said)
      if (key.find("lanes") != std::string::npos) tags.name(key, "it makes more than 30 lanes");
    read.unread = tags.take_unread();
    return read;
  }
  read.both_ways = lanes.middle;
  read.roadway_offset = placed_offset(lanes, use, tags);
  const bool known = lanes.along.known && (tags.one_way() || lanes.against.known);
  if (known || (lanes.total && !tags.takes_turns()))
    read.lane_count = lanes.along.driving() + lanes.against.driving() + lanes.middle;
  if (tags.takes_turns()) read.lane_count = lanes.middle;
  tags.name_strangers();
  read.unread = tags.take_unread();
  read.forward = std::move((turned ? lanes.against : lanes.along).lanes);
  read.backward = std::move((turned ? lanes.along : lanes.against).lanes);
  read.forward_known = !lanes.shared && (turned ? lanes.against : lanes.along).known;
  read.backward_known = !lanes.shared && (turned ? lanes.along : lanes.against).known;
  return read;
}

}  // namespace streetgen
