#include "osm/bus_lanes.hpp"

#include "osm/car_access.hpp"

namespace streetgen {

namespace {

void count_bus_lanes(WayTags& tags, BusWishes& wishes) {
  for (const std::string base : {"lanes:psv", "lanes:bus"}) {
    for (const Heading heading : {Heading::along, Heading::against}) {
      BusWish& wish = heading == Heading::along ? wishes.along : wishes.against;
      const std::string key = tags.said_of(base, heading);
      const std::optional<int> count = tags.count(key, 0);
      if (count > 0) wish = {std::max(*count, wish.near), 0, true, key};
    }
    if (tags.one_way() || wishes.along.lanes() + wishes.against.lanes() > 0) continue;
    const std::optional<int> count = tags.count(base, 0);
    if (count > 0 && *count % 2 == 0)
      wishes = {{*count / 2, 0, true, base}, {*count / 2, 0, true, base}};
    else if (count > 0)
      tags.name(base, "it says no direction");
  }
}

void look_at_kerb(RoadSide kerb, WayTags& tags, BusWishes& wishes) {
  std::string key = tags.said_of("busway", kerb),
              word = word_among(tags.value(key), {"lane", "opposite_lane"});
  const bool near = kerb == RoadSide::near;
  if (word.empty()) {
    key = "busway";
    word = word_among(tags.value(key), {"lane", "opposite_lane"});
    // Without a side it speaks of the near kerb of each direction.
    if (tags.one_way() && (word == "opposite_lane") == near) return;
  }
  if (word != "lane" && word != "opposite_lane") return;
  const bool open_to_buses = tags.value("oneway:bus") == "no" || tags.value("oneway:psv") == "no";
  const bool against = tags.one_way() ? word == "opposite_lane" || (!near && open_to_buses) : !near;
  BusWish& wish = against ? wishes.against : wishes.along;
  if (wish.by_count) return;
  wish.key = key;
  ++(near || against ? wish.near : wish.far);
}

bool lets_in(const std::string& word) {
  return word == "yes" || word == "designated" || word == "official" || word == "permissive";
}

// The first of these keys that has a value, with the suffix of a direction or without.
std::string nearest_key(std::initializer_list<const char*> keys, Heading heading,
                        const WayTags& tags) {
  for (const char* key : keys)
    for (const std::string& each : {tags.key_of(key, heading), std::string(key)})
      if (!tags.value(each).empty()) return each;
  return *keys.begin();
}

// The tag that lets buses in; empty: none does.
std::string key_of_buses(Heading heading, const WayTags& tags) {
  for (const char* name : {"bus", "psv"})
    if (const std::string key = nearest_key({name}, heading, tags); lets_in(tags.value(key)))
      return key;
  return {};
}

std::string word_of_cars(Heading heading, const WayTags& tags) {
  return tags.value(nearest_key({"motorcar", "motor_vehicle", "vehicle", "access"}, heading, tags));
}

bool for_buses_alone(Heading heading, const WayTags& tags) {
  return tags.value("highway") == "busway" ||
         (shuts_cars_out(word_of_cars(heading, tags)) && !key_of_buses(heading, tags).empty());
}

}  // namespace

BusWishes wanted_bus_lanes(WayTags& tags) {
  BusWishes wishes;
  count_bus_lanes(tags, wishes);
  if (tags.takes_turns()) return wishes;
  look_at_kerb(RoadSide::near, tags, wishes);
  look_at_kerb(RoadSide::far, tags, wishes);
  // A kerb has no bus lane beside others that are all bus lanes.
  if (for_buses_alone(Heading::along, tags) && !wishes.along.by_count) wishes.along = {};
  if (!tags.one_way() && for_buses_alone(Heading::against, tags) && !wishes.against.by_count)
    wishes.against = {};
  return wishes;
}

void lay_bus_lanes(const BusWish& wish, bool beside, DrivingSide side, HeadingLanes& lanes,
                   WayTags& tags) {
  if (wish.lanes() == 0 || lanes.has(LaneKind::bus)) return;
  if (for_buses_alone(lanes.heading, tags) && wish.by_count && !lanes.known && !beside) {
    lanes.lanes.assign(wish.lanes(), {LaneKind::bus});
    lanes.known = true;
    return;
  }
  const int driving = lanes.driving();
  const bool within = lanes.known && !beside &&
                      (driving > wish.lanes() || (wish.by_count && driving == wish.lanes()));
  if (lanes.known && !beside && !within)
    tags.name(wish.key, "the lanes that are counted leave none beside the bus lanes");
  for (const RoadSide kerb : {RoadSide::near, RoadSide::far})
    for (int i = 0; i < (kerb == RoadSide::near ? wish.near : wish.far); ++i) {
      if (!within) {
        put_at(kerb, side, {LaneKind::bus}, lanes.lanes);
        continue;
      }
      const auto is_general = [](const OsmLane& lane) { return lane.kind == LaneKind::general; };
      if ((kerb == RoadSide::near) == (side == DrivingSide::right)) {
        const auto last = std::find_if(lanes.lanes.rbegin(), lanes.lanes.rend(), is_general);
        if (last != lanes.lanes.rend()) last->kind = LaneKind::bus;
      } else {
        const auto first = std::find_if(lanes.lanes.begin(), lanes.lanes.end(), is_general);
        if (first != lanes.lanes.end()) first->kind = LaneKind::bus;
      }
    }
}

void give_to_buses(HeadingLanes& lanes, WayTags& tags) {
  if (const std::string key = key_of_buses(lanes.heading, tags);
      !key.empty() && lets_cars_end(word_of_cars(lanes.heading, tags)))
    tags.name(key, "cars may drive there too, if not through: no lane is for buses alone");
  if (!for_buses_alone(lanes.heading, tags)) return;
  for (OsmLane& lane : lanes.lanes)
    if (lane.kind == LaneKind::general) lane.kind = LaneKind::bus;
}

void give_to_carpools(HeadingLanes& lanes, const WayTags& tags) {
  if (lanes.has(LaneKind::carpool) ||
      tags.value(nearest_key({"hov"}, lanes.heading, tags)) != "designated")
    return;
  for (OsmLane& lane : lanes.lanes)
    if (lane.kind == LaneKind::general) lane.kind = LaneKind::carpool;
}

}  // namespace streetgen
