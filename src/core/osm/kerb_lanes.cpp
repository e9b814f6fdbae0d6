#include "osm/kerb_lanes.hpp"

#include "osm/lane_list.hpp"
#include "osm/side_strips.hpp"

namespace streetgen {

namespace {

// Words of which several may stand in one value: those that make a lane.
constexpr std::initializer_list<const char*> cycle_words = {"lane", "soft_lane", "opposite_lane"};
constexpr std::initializer_list<const char*> along_words = {"lane", "soft_lane"};
constexpr std::initializer_list<const char*> against_words = {"opposite_lane"};
constexpr std::initializer_list<const char*> parking_words = {"perpendicular", "diagonal",
                                                              "parallel", "marked"};
constexpr std::initializer_list<const char*> on_lane_words = {"on_street", "lane",
                                                              "painted_area_only"};

// In what way cars stand: of several that which needs most room; else all that is said.
std::string deepest_of(const std::string& key, WayTags& tags) {
  const std::string said = tags.value(key);
  std::string deepest = said;
  int ways = 0;
  for (const char* word : parking_words)
    if (word_among(said, {word}) == word && ++ways == 1) deepest = word;
  if (ways > 1) tags.name(key, "cars stand in several ways: the deepest counts");
  return deepest;
}

CycleWish cycle_lanes_at(RoadSide kerb, WayTags& tags) {
  CycleWish wish;
  wish.key = tags.said_of("cycleway", kerb);
  std::string word = word_among(tags.value(wish.key), cycle_words);
  const bool near = kerb == RoadSide::near, sided = !word.empty();
  // A track on the roadway is a lane of it.
  if (const std::string track = cycle_track_key(kerb, tags);
      !track.empty() && track_is_on_roadway(kerb, tags)) {
    wish.key = track;
    word = tags.one_way() && !near && !sided ? "opposite_lane" : "lane";
  } else if (!sided) {
    wish.key = "cycleway";
    // Without a side it speaks of the near kerb of each direction.
    word = word_among(tags.value(wish.key), !tags.one_way() ? cycle_words
                                            : near          ? along_words
                                                            : against_words);
    if (tags.one_way() && (word == "opposite_lane") == near) return wish;
    if (!tags.one_way() && word == "opposite_lane") {
      tags.name(wish.key, "a street of both directions has no lane against the traffic");
      return wish;
    }
  }
  if (word == "yes") tags.name(wish.key, "it says neither lane nor track");
  if (word != "lane" && word != "soft_lane" && word != "opposite_lane") return wish;
  std::string oneway = tags.value(tags.key_of("cycleway", kerb) + ":oneway");
  if (oneway.empty()) oneway = tags.value("cycleway:both:oneway");
  const bool usual_against =
      tags.one_way() ? !near && sided && tags.value("oneway:bicycle") == "no" : !near;
  // It speaks of the direction of the way as it is drawn.
  wish.against = word == "opposite_lane" || (oneway == "-1"    ? !tags.drawn_against()
                                             : oneway == "yes" ? tags.drawn_against()
                                                               : usual_against);
  wish.along = !wish.against;
  if (oneway == "no") wish.along = wish.against = true;
  return wish;
}

// The first that is a width of a lane.
std::optional<double> width_at(RoadSide kerb, WayTags& tags) {
  for (const char* said : {":width", ":est_width"})
    for (const std::string& key :
         {tags.key_of("cycleway", kerb), std::string("cycleway:both"), std::string("cycleway")})
      if (const std::string word = tags.value(key + said); !word.empty()) {
        if (const std::optional<double> width = lane_width_of(word, LaneKind::cycle)) return width;
        tags.name(key + said, "it is no width of a lane");
      }
  return std::nullopt;
}

void put_cycle_lane(RoadSide kerb, DrivingSide side, std::optional<double> width,
                    HeadingLanes& lanes) {
  if (kerb == RoadSide::near
          ? lanes.has(LaneKind::cycle)
          : !lanes.lanes.empty() &&
                (lies_last(kerb, side) ? lanes.lanes.back() : lanes.lanes.front()).kind ==
                    LaneKind::cycle) {
    for (OsmLane& lane : lanes.lanes)
      if (lane.kind == LaneKind::cycle && !lane.width) lane.width = width;
    return;
  }
  put_at(kerb, side, {LaneKind::cycle, false, {}, {}, width}, lanes.lanes);
}

// A tag says of which kind or how wide a cycle lane is that no tag tells of.
void name_cycle_lane_without_place(RoadSide kerb, WayTags& tags) {
  const std::string side = tags.key_of("cycleway", kerb), kind = tags.value(side + ":lane");
  if (kind == "advisory" || kind == "exclusive" || kind == "soft_lane")
    tags.name(side + ":lane", "no cycle lane is there");
  const auto silent = [&](RoadSide each) {
    return tags.value(tags.said_of("cycleway", each)).empty();
  };
  if (!tags.value("cycleway").empty() || !silent(kerb)) return;
  std::vector<std::string> starts{side};
  if (silent(RoadSide::near) && silent(RoadSide::far)) starts.push_back("cycleway:both");
  for (const std::string& start : starts)
    for (const char* what : {":width", ":est_width", ":oneway"})
      if (!tags.value(start + what).empty()) tags.name(start + what, "no cycle lane is there");
}

// Do cars stand on a lane, by the tags of this kerb?
bool cars_stand_on_lane(RoadSide kerb, const std::string& stands, WayTags& tags) {
  const std::string place = word_among(tags.value(tags.said_of("parking", kerb)), {"lane"});
  if (place == "yes")
    tags.name(tags.said_of("parking", kerb), "it does not say whether cars stand on a lane");
  else if (!place.empty())
    return place == "lane";
  if (!is_among(stands, parking_words)) return false;
  // The older scheme says the place beneath the way in which they stand.
  for (const std::string& key :
       {tags.key_of("parking:lane", kerb), std::string("parking:lane:both")})
    if (const std::string where = tags.value(key + ":" + stands); !where.empty())
      return is_among(word_among(where, on_lane_words), on_lane_words);
  return true;
}

// A tag says how cars stand at a kerb of which none says whether they do.
void name_parking_without_place(RoadSide kerb, WayTags& tags) {
  const auto silent = [&](RoadSide each) {
    return tags.value(tags.said_of("parking", each)).empty() &&
           tags.value(tags.said_of("parking:lane", each)).empty();
  };
  if (!silent(kerb)) return;
  const auto name = [&](const std::string& place) {
    std::vector<std::string> keys{"parking" + place + ":width", "parking" + place + ":orientation"};
    for (const std::string how : parking_words) keys.push_back("parking:lane" + place + ":" + how);
    for (const std::string& key : keys)
      if (!tags.value(key).empty()) tags.name(key, "no tag says where cars stand");
  };
  name(tags.key_of("", kerb));
  if (silent(RoadSide::near) && silent(RoadSide::far)) name(":both");
}

// Without a width where cars stand along the kerb and no tag states one.
OsmLane parking_lane_at(RoadSide kerb, const std::string& stands, const OsmLaneUse& use,
                        WayTags& tags) {
  OsmLane lane{LaneKind::parking, false};
  for (const std::string& key : {tags.key_of("parking", kerb), std::string("parking:both")})
    if (const std::string said = tags.value(key + ":width"); !said.empty()) {
      if ((lane.width = lane_width_of(said, LaneKind::parking))) return lane;
      tags.name(key + ":width", "it is no width of a lane");
    }
  std::string turned = deepest_of(tags.key_of("parking", kerb) + ":orientation", tags);
  if (turned.empty()) turned = deepest_of("parking:both:orientation", tags);
  if (turned.empty()) turned = stands;
  if (turned == "diagonal") lane.width = use.diagonal_depth;
  if (turned == "perpendicular") lane.width = use.perpendicular_depth;
  lane.width_usual = lane.width.has_value();
  return lane;
}

}  // namespace

CycleWishes wanted_cycle_lanes(WayTags& tags) {
  return {cycle_lanes_at(RoadSide::near, tags), cycle_lanes_at(RoadSide::far, tags)};
}

void lay_cycle_lanes(const CycleWishes& wishes, WayLanes& lanes, WayTags& tags) {
  for (const RoadSide kerb : {RoadSide::near, RoadSide::far}) {
    const CycleWish& wish = kerb == RoadSide::near ? wishes.near : wishes.far;
    if (!wish.along && !wish.against) {
      name_cycle_lane_without_place(kerb, tags);
      continue;
    }
    const std::optional<double> width = width_at(kerb, tags);
    const bool near = kerb == RoadSide::near;
    // A direction has its own lanes on its side alone: there runs no lane of the other one.
    const bool strange = tags.one_way() ? near && wish.against : near ? wish.against : wish.along;
    if (strange)
      tags.name(wish.key, "a cycle lane at this kerb runs in the direction of the lanes beside it");
    if (tags.one_way() ? near || wish.along : near)
      put_cycle_lane(kerb, lanes.side, width, lanes.along);
    if (tags.one_way() ? !near && wish.against : !near)
      put_cycle_lane(RoadSide::near, lanes.side, width, lanes.against);
  }
}

void name_shared_bus_lanes(const WayLanes& lanes, WayTags& tags) {
  for (const char* key : {"cycleway", "cycleway:both", "cycleway:left", "cycleway:right"}) {
    const std::string word = word_among(tags.value(key), {"share_busway", "opposite_share_busway"});
    const bool against = word == "opposite_share_busway";
    if (!against && word != "share_busway") continue;
    if (!lanes.against.has(LaneKind::bus) && (against || !lanes.along.has(LaneKind::bus)))
      tags.name(key, "no bus lane is there that bicycles share");
  }
}

void lay_parking_lanes(WayLanes& lanes, const OsmLaneUse& use, WayTags& tags) {
  for (const RoadSide kerb : {RoadSide::near, RoadSide::far}) {
    const std::string stands = deepest_of(tags.said_of("parking:lane", kerb), tags);
    if (!cars_stand_on_lane(kerb, stands, tags)) {
      name_parking_without_place(kerb, tags);
      continue;
    }
    const bool beyond = kerb == RoadSide::far &&
                        (!tags.one_way() || tags.takes_turns() || !lanes.against.lanes.empty());
    std::vector<OsmLane>& beside = beyond ? lanes.against.lanes : lanes.along.lanes;
    const RoadSide seen = beyond ? RoadSide::near : kerb;
    OsmLane parked = parking_lane_at(kerb, stands, use, tags);
    if (!beside.empty() && cars_stand_before_track(kerb, tags)) {
      OsmLane& at_kerb = lies_last(seen, lanes.side) ? beside.back() : beside.front();
      if (at_kerb.kind == LaneKind::cycle) std::swap(at_kerb, parked);
    }
    put_at(seen, lanes.side, parked, beside);
  }
}

}  // namespace streetgen
