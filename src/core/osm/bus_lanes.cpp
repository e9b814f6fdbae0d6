#include "osm/bus_lanes.hpp"

#include "osm/way_access.hpp"

namespace streetgen {

namespace {

void look_at_kerb(RoadSide kerb, WayTags& tags, BusWishes& wishes) {
  std::string key = tags.said_of("busway", kerb),
              word = word_among(tags.value(key), {"lane", "opposite_lane"});
  const bool near = kerb == RoadSide::near, sided = !word.empty();
  if (!sided) {
    key = "busway";
    word = word_among(tags.value(key), {"lane", "opposite_lane"});
    // Without a side it speaks of the near kerb of each direction.
    if (tags.one_way() && (word == "opposite_lane") == near) return;
  }
  if (word != "lane" && word != "opposite_lane") return;
  if (word == "opposite_lane" && !tags.one_way() && !sided)
    return tags.name(key, "a street of both directions has no lane against the traffic");
  if (word == "opposite_lane" && near)
    tags.name(key, "a bus lane at this kerb runs in the direction of the lanes beside it");
  const bool open_to_buses = tags.value("oneway:bus") == "no" || tags.value("oneway:psv") == "no";
  const bool against = tags.one_way() ? word == "opposite_lane" || (!near && open_to_buses) : !near;
  BusWish& wish = against ? wishes.against : wishes.along;
  wish.key = key;
  ++(near || against ? wish.near : wish.far);
}

// The greatest number that keys of buses state, and its key.
struct BusCount {
  std::optional<int> lanes{};
  std::string key{};
};

BusCount counted_at(const std::string& suffix, WayTags& tags) {
  BusCount most;
  for (const char* base : {"lanes:psv", "lanes:bus"})
    if (const std::optional<int> count = tags.count(base + suffix, 0);
        count && count >= most.lanes.value_or(0))
      most = {count, base + suffix};
  return most;
}

// Lanes that no kerb speaks of lie at the near one.
void settle(const BusCount& count, BusWish& wish, WayTags& tags) {
  if (!count.lanes) return;
  if (*count.lanes < wish.lanes())
    return tags.name(count.key, "tags of the kerbs have more bus lanes");
  if (*count.lanes == 0) return;
  wish.unplaced = *count.lanes - wish.lanes();
  wish.near += wish.unplaced;
  wish.by_count = true;
  wish.key = count.key;
}

// A number without a direction counts the bus lanes of both.
void settle_both(BusCount count, BusWishes& wishes, WayTags& tags) {
  if (!count.lanes || wishes.along.by_count || (!tags.one_way() && wishes.against.by_count)) return;
  if (tags.one_way()) {
    if (*count.lanes < wishes.against.lanes())
      return tags.name(count.key, "tags of the kerbs have more bus lanes");
    *count.lanes -= wishes.against.lanes();
    return settle(count, wishes.along, tags);
  }
  const int at_kerbs = wishes.along.lanes() + wishes.against.lanes();
  if (*count.lanes == at_kerbs) {
    for (BusWish* wish : {&wishes.along, &wishes.against}) wish->by_count = wish->lanes() > 0;
  } else if (*count.lanes % 2 == 0) {
    *count.lanes /= 2;
    settle(count, wishes.along, tags);
    settle(count, wishes.against, tags);
  } else if (*count.lanes < at_kerbs) {
    tags.name(count.key, "tags of the kerbs have more bus lanes");
  } else {
    tags.name(count.key, "it says no direction");
  }
}

// Of a street that one direction has at a time.
void name_bus_lanes(WayTags& tags) {
  const char* const reason = "all lanes of the way are for both directions, one at a time";
  for (const std::string suffix : {"", ":forward", ":backward"})
    if (const BusCount count = counted_at(suffix, tags); count.lanes > 0)
      tags.name(count.key, reason);
  for (const char* key : {"busway", "busway:left", "busway:right", "busway:both"})
    if (word_among(tags.value(key), {"lane"}) == "lane") tags.name(key, reason);
}

bool for_buses_alone(Heading heading, const WayTags& tags) {
  return way_access(heading, tags) == Access::bus;
}

}  // namespace

BusWishes wanted_bus_lanes(WayTags& tags) {
  BusWishes wishes;
  if (tags.takes_turns()) {
    name_bus_lanes(tags);
    return wishes;
  }
  look_at_kerb(RoadSide::near, tags, wishes);
  look_at_kerb(RoadSide::far, tags, wishes);
  settle(counted_at(tags.key_of("", Heading::along), tags), wishes.along, tags);
  settle(counted_at(tags.key_of("", Heading::against), tags), wishes.against, tags);
  settle_both(counted_at("", tags), wishes, tags);
  // A kerb has no bus lane beside others that are all bus lanes.
  const auto drop = [&](Heading heading, BusWish& wish) {
    if (wish.lanes() > 0 && !wish.by_count && for_buses_alone(heading, tags)) wish = {};
  };
  drop(Heading::along, wishes.along);
  if (!tags.one_way()) drop(Heading::against, wishes.against);
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
  if (wish.unplaced > 0 && driving > (within ? wish.lanes() : 0))
    tags.name(wish.key, "no tag says at which kerb the lanes lie: the near one is taken");
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

void give_to_those_alone(HeadingLanes& lanes, WayTags& tags) {
  if (const std::string key = key_of_buses(lanes.heading, tags);
      !key.empty() && lets_cars_end(access_of_cars(lanes.heading, tags)))
    tags.name(key, "cars may drive there too, if not through: no lane is for buses alone");
  const Access alone = way_access(lanes.heading, tags);
  const LaneKind kind = alone == Access::bus       ? LaneKind::bus
                        : alone == Access::carpool ? LaneKind::carpool
                                                   : LaneKind::general;
  if (kind == LaneKind::carpool && lanes.has(kind)) return;
  for (OsmLane& lane : lanes.lanes)
    if (lane.kind == LaneKind::general) lane.kind = kind;
}

}  // namespace streetgen
