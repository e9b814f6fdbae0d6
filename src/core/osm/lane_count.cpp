#include "osm/lane_count.hpp"

#include "osm/way_access.hpp"

namespace streetgen {

namespace {

constexpr int most_in_turn = 30;

using Reading = LaneLists::Reading;

// One direction while it is counted.
struct Count {
  const LaneLists& lists;
  std::string key;                  // lanes:forward or lanes:backward
  std::optional<int> stated;        // by that tag
  std::vector<Reading> readings;    // of the lists
  const Reading* chosen = nullptr;  // null: the lists fit nothing, or there are none
  std::optional<int> lanes{};       // what tag lanes counts; none: unknown
  bool buses_beside = false;        // lanes does not include the bus lanes

  int counted() const { return chosen ? chosen->counted : lanes.value_or(0); }

  void choose(const Reading& reading) {
    chosen = &reading;
    lanes = reading.counted;
  }

  // The reading of the lists that fits `target`; the longest reading where none does.
  void settle(std::optional<int> target, const std::string& named, WayTags& tags) {
    for (const Reading& reading : readings)
      if (reading.counted == target) {
        if (reading.disagrees)
          tags.name(named, "lists of lanes say that it counts cycle lanes too");
        return choose(reading);
      }
    if (!readings.empty() &&
        (!target || static_cast<int>(readings.front().kinds.size()) > *target)) {
      if (target) tags.name(named, "a list has more lanes");
      return choose(readings.front());
    }
    lanes = target;
  }
};

void settle_by_total(int total, Count& along, Count& against, WayTags& tags) {
  const char* const differs = "the lanes of its directions are others";
  if (!along.readings.empty() && !against.readings.empty()) {
    // The readings that suppose least, if they are the only ones.
    int least = 3, ways = 0;
    const Reading *chosen_forth = nullptr, *chosen_back = nullptr;
    for (const Reading& forth : along.readings)
      for (const Reading& back : against.readings) {
        const int supposed = forth.supposed + back.supposed;
        if (forth.counted + back.counted != total || supposed > least) continue;
        ways = supposed < least ? 1 : ways + 1;
        least = supposed;
        chosen_forth = &forth, chosen_back = &back;
      }
    if (ways == 1) {
      if (chosen_forth->disagrees || chosen_back->disagrees)
        tags.name("lanes", "lists of lanes say that it counts cycle lanes too");
      along.choose(*chosen_forth);
      against.choose(*chosen_back);
      return;
    }
    along.settle(std::nullopt, "lanes", tags);
    against.settle(std::nullopt, "lanes", tags);
    return tags.name("lanes", differs);
  }
  Count& listed = along.readings.empty() ? against : along;
  Count& other = along.readings.empty() ? along : against;
  for (const Reading& reading : listed.readings)
    if (reading.counted < total) {
      if (reading.disagrees)
        tags.name("lanes", "lists of lanes say that it counts cycle lanes too");
      listed.choose(reading);
      other.lanes = total - reading.counted;
      return;
    }
  listed.settle(std::nullopt, "lanes", tags);
  tags.name("lanes", differs);
}

// No list and no tag says how the lanes of a two-way street are shared.  It is the same for both
// directions: what is left over lies in the middle, or tag lanes counts none of those there.
void share(WayLanes& lanes, int total, const BusWishes& buses, Count& along, Count& against,
           WayTags& tags) {
  const int forth = buses.along.lanes(), back = buses.against.lanes();
  const int rest = total - forth - back;
  lanes.shared = true;
  if (rest == 0 && buses.along.by_count && buses.against.by_count) {
    lanes.shared = false;
    along.lanes = forth;
    against.lanes = back;
  } else if (rest >= 2 && rest % 2 == 0) {
    along.lanes = rest / 2 + forth;
    against.lanes = rest / 2 + back;
  } else if (total % 2 == 0 && total / 2 > std::max(forth, back)) {
    along.lanes = against.lanes = total / 2;
  } else if (forth + back > 0 && rest < 3) {
    tags.name("lanes", "it leaves no lane each way beside the bus lanes");
  } else if (lanes.middle > 0) {
    along.lanes = (rest + 1) / 2 + forth;
    against.lanes = (rest + 1) / 2 + back;
    tags.name("lanes", "it does not count the lane in the middle, or leaves one of no direction");
  } else {
    along.lanes = rest / 2 + forth;
    against.lanes = rest / 2 + back;
    if (total > 1)
      tags.name("lanes", "one lane more is of no direction, and lies in the middle for both");
    ++lanes.middle;
  }
}

void count_both(WayLanes& lanes, const BusWishes& buses, Count& along, Count& against,
                WayTags& tags) {
  const int total = lanes.total.value_or(0) - lanes.middle;
  const auto left_by = [&](const Count& stated) -> std::optional<int> {
    if (total > *stated.stated) return total - *stated.stated;
    tags.name("lanes", "it leaves no lane for the other direction");
    return std::nullopt;
  };
  if (along.stated && against.stated) {
    const int sum = *along.stated + *against.stated;
    if (lanes.total && total != sum) {
      const int with_buses = sum + buses.along.lanes() + buses.against.lanes();
      along.buses_beside = against.buses_beside = with_buses == total;
      if (with_buses != total) tags.name("lanes", "the lanes of its directions are others");
    }
    along.settle(along.stated, along.key, tags);
    against.settle(against.stated, against.key, tags);
  } else if (along.stated || against.stated) {
    Count& stated = along.stated ? along : against;
    Count& other = along.stated ? against : along;
    stated.settle(stated.stated, stated.key, tags);
    other.settle(lanes.total ? left_by(stated) : std::nullopt, "lanes", tags);
  } else if (!lanes.total) {
    along.settle(std::nullopt, "", tags);
    against.settle(std::nullopt, "", tags);
  } else if (total < 1) {
    // A lane to turn from lies between others.
    along.lanes = against.lanes = tags.value("turn:lanes:both_ways").empty() ? 0 : 1;
    if (total < 0 || along.lanes > 0) tags.name("lanes", "there are more lanes in the middle");
  } else if (along.readings.empty() && against.readings.empty()) {
    share(lanes, total, buses, along, against, tags);
  } else {
    settle_by_total(total, along, against, tags);
  }
}

void count_one_way(const WayLanes& lanes, const BusWishes& buses, Count& along, Count& against,
                   WayTags& tags) {
  const bool for_buses = tags.value("oneway:bus") == "no" || tags.value("oneway:psv") == "no";
  // A list alone makes lanes against the traffic where tag lanes counts them.
  const auto counts_both = [&] {
    for (const Reading& back : against.readings)
      for (const Reading& forth : along.readings)
        if (back.counted + forth.counted == *lanes.total) return true;
    return along.readings.empty();
  };
  const bool open_against = for_buses || tags.value("oneway:bicycle") == "no";
  if (against.stated > 0 ||
      (against.lists.say_who() && (open_against || !lanes.total || counts_both())))
    against.settle(against.stated > 0 ? against.stated : std::nullopt, against.key, tags);
  else if (!against.stated && for_buses && along.stated && lanes.total > along.stated)
    against.lanes = *lanes.total - *along.stated;
  if (!against.chosen)
    for (const LaneLists::List& list : against.lists.all())
      if (!against.lanes || *against.lanes != static_cast<int>(list.words.size()))
        tags.name(list.key, "no lanes run against the traffic");
  const int back = std::max(against.counted(), buses.against.lanes());
  if (along.stated) {
    along.settle(along.stated, along.key, tags);
    if (lanes.total && along.counted() + back != *lanes.total) {
      if (*along.stated < *lanes.total && back == 0 && along.counted() == *along.stated)
        along.lanes = lanes.total, along.chosen = nullptr;
      tags.name("lanes", "the lanes of its directions are others");
    }
    return;
  }
  if (!lanes.total) return along.settle(std::nullopt, "", tags);
  const auto fits = [&](int count) {
    return std::any_of(along.readings.begin(), along.readings.end(),
                       [&](const Reading& reading) { return reading.counted == count; });
  };
  const int rest = *lanes.total - back;
  if (back > 0 && (rest < 1 || (!fits(rest) && fits(*lanes.total)))) {
    tags.name("lanes", "it does not count the lanes against the traffic");
    return along.settle(lanes.total, "lanes", tags);
  }
  along.settle(rest, "lanes", tags);
}

HeadingLanes lanes_of(const Count& count, Heading heading, int usual) {
  HeadingLanes lanes{heading, {}};
  lanes.known = count.lanes.has_value();
  if (count.chosen) {
    for (const LaneKind kind : count.chosen->kinds) lanes.lanes.push_back({kind});
    lanes.listed = count.chosen->kinds.size();
  } else {
    lanes.lanes.assign(count.lanes.value_or(usual), OsmLane{});
  }
  return lanes;
}

// Who drives against the traffic of a one-way street: buses, or else bicycles.
void close_to_cars(HeadingLanes& lanes, const Count& count, WayTags& tags) {
  const bool buses = lets_buses_in(Heading::against, tags);
  if (lanes.has(LaneKind::general) && !buses && tags.value("oneway:bicycle") != "no") {
    std::vector<std::string> keys{count.key};
    for (const LaneLists::List& list : count.lists.all()) keys.push_back(list.key);
    tags.name_first_of(keys, "nothing says who may drive against the traffic");
  }
  for (OsmLane& lane : lanes.lanes)
    if (lane.kind == LaneKind::general)
      lane.kind = buses || tags.value("oneway:bicycle") != "no" ? LaneKind::bus : LaneKind::cycle;
}

// Lanes in the middle.
int middle_lanes(const WayLanes& lanes, WayTags& tags) {
  const std::optional<int> both = tags.count("lanes:both_ways", 0),
                           reversible = tags.count("lanes:reversible", 0);
  const std::string turns = tags.value("turn:lanes:both_ways");
  int middle = both.value_or(0) + reversible.value_or(0);
  if (!both && !turns.empty()) middle += static_cast<int>(parted_list(turns).size());
  if (!both && turns.empty() && tags.value("centre_turn_lane") == "yes") {
    ++middle;
    if (lanes.total && *lanes.total % 2 == 0)
      tags.name("centre_turn_lane", "lanes counts an even number, as if there were none");
  }
  if (middle > 6 || (middle > 0 && tags.one_way())) {
    tags.name_first_of(
        {"turn:lanes:both_ways", "lanes:both_ways", "lanes:reversible", "centre_turn_lane"},
        middle > 6 ? "it is more than 6 lanes" : "a one-way street has no lanes for both");
    return 0;
  }
  if (!turns.empty()) {
    const std::string turned = lanes.side == DrivingSide::right ? "left" : "right";
    const std::vector<std::string> words = parted_list(turns);
    if (static_cast<int>(words.size()) != middle)
      tags.name("turn:lanes:both_ways", "the lanes in the middle are others");
    for (const std::string& word : words)
      if (!word.empty() && word != "none" && word != turned)
        tags.name("turn:lanes:both_ways", "a lane in the middle leads to the " + turned + " alone");
  }
  return middle;
}

// The lanes of a street that one direction has at a time.
int lanes_in_turn(const WayLanes& lanes, WayTags& tags) {
  int stated = lanes.middle;
  for (const char* key : {"lanes:forward", "lanes:backward"}) {
    const std::optional<int> count = tags.count(key, 0);
    stated += count.value_or(0);
    if (count) tags.name(key, "all lanes of the way are for both directions, one at a time");
  }
  if (lanes.total) {
    if (lanes.middle > 0 && lanes.middle != *lanes.total)
      tags.name("lanes", "all lanes of the way are for both directions, one at a time");
    return *lanes.total;
  }
  if (stated > 0) return std::min(stated, most_in_turn);
  const bool one = tags.value("oneway") == "alternating";
  tags.name("oneway",
            one ? "no tag counts its lanes: it has one" : "no tag counts its lanes: it has two");
  return one ? 1 : 2;
}

}  // namespace

WayLanes counted_lanes(const LaneLists& along, const LaneLists& against, const CycleWishes& cycles,
                       const OsmLaneUse& use, WayTags& tags) {
  WayLanes lanes;
  lanes.side = use.driving_side;
  lanes.total = tags.count("lanes", 1);
  lanes.middle = middle_lanes(lanes, tags);
  if (lanes.total && lanes.middle > 0 && *lanes.total % 2 == 0 &&
      tags.value("centre_turn_lane") == "yes" && tags.value("lanes:both_ways").empty())
    ++*lanes.total;
  const int least = tags.one_way() ? 0 : 1;
  const BusWishes buses = wanted_bus_lanes(tags);
  const auto count_of = [&](const LaneLists& lists, Heading heading) {
    const std::string key = tags.key_of("lanes", heading);
    const bool forth = heading == Heading::along, right = lanes.side == DrivingSide::right;
    const bool near = forth ? cycles.near.along : cycles.far.against,
               far = forth && tags.one_way() && cycles.far.along;
    return Count{lists, key, tags.count(key, forth ? 1 : least),
                 lists.readings({right ? far : near, right ? near : far}, tags)};
  };
  if (tags.takes_turns()) {
    for (const LaneLists* lists : {&along, &against})
      for (const LaneLists::List& list : lists->all())
        tags.name(list.key, "all lanes of the way are for both directions, one at a time");
    lanes.middle = lanes_in_turn(lanes, tags);
    return lanes;
  }
  Count forth = count_of(along, Heading::along), back = count_of(against, Heading::against);
  if (tags.one_way())
    count_one_way(lanes, buses, forth, back, tags);
  else
    count_both(lanes, buses, forth, back, tags);
  lanes.along = lanes_of(forth, Heading::along, tags.one_way() ? use.usual_lanes : 1);
  lanes.against = lanes_of(back, Heading::against, tags.one_way() ? 0 : 1);
  if (tags.one_way()) close_to_cars(lanes.against, back, tags);
  const int told =
      forth.counted() + lanes.middle +
      (tags.one_way() ? std::max(back.counted(), buses.against.lanes()) : back.counted());
  if (lanes.total && forth.lanes && (tags.one_way() || back.lanes) && told != *lanes.total &&
      !forth.buses_beside)
    tags.name("lanes", "the lanes of its directions are others");
  lay_bus_lanes(buses.along, forth.buses_beside, lanes.side, lanes.along, tags);
  lay_bus_lanes(buses.against, back.buses_beside || (tags.one_way() && lanes.against.lanes.empty()),
                lanes.side, lanes.against, tags);
  return lanes;
}

}  // namespace streetgen
