#include "osm/way_access.hpp"

#include <algorithm>
#include <optional>

namespace streetgen {

namespace {

// Of a tag, that of the direction before that of the way; none where there is neither.
std::optional<Access> said_of(const char* key, Heading heading, const WayTags& tags) {
  for (const std::string& each : {tags.key_of(key, heading), std::string(key)})
    if (const std::string word = tags.value(each); !word.empty()) return access_of(word);
  return std::nullopt;
}

std::optional<Access> first_said(std::initializer_list<const char*> keys, Heading heading,
                                 const WayTags& tags) {
  for (const char* key : keys)
    if (const std::optional<Access> said = said_of(key, heading, tags)) return said;
  return std::nullopt;
}

// Who drives on a way of a class of which no tag says it.
Access usual_access(const std::string& highway) {
  if (highway == "busway" || highway == "bus_guideway") return Access::bus;
  if (highway == "cycleway" || highway == "path") return Access::cycle;
  if (highway == "pedestrian" || highway == "footway" || highway == "steps") return Access::nobody;
  return Access::all;
}

bool some_word_lets_in(const std::string& list) {
  const std::vector<std::string> words = parted_list(list);
  return std::any_of(words.begin(), words.end(), [](const std::string& word) {
    return !word.empty() && (word == "lane" || lets_in(access_of(word)));
  });
}

bool counts_lanes(const std::string& number) {
  return number.find_first_of("123456789") != number.npos;
}

bool has_kerb_lane(Heading heading, const WayTags& tags) {
  const bool along = heading == Heading::along;
  const auto says = [&](const std::string& key, const char* word) {
    return word_among(tags.value(key), {word}) == word;
  };
  if (tags.one_way() && !along)
    return says("busway", "opposite_lane") || says("busway:left", "opposite_lane") ||
           says("busway:right", "opposite_lane");
  if (says("busway", "lane") || says("busway:both", "lane")) return true;
  if (tags.one_way()) return says("busway:left", "lane") || says("busway:right", "lane");
  return says(tags.key_of("busway", along ? RoadSide::near : RoadSide::far), "lane");
}

}  // namespace

bool lets_buses_in(Heading heading, const WayTags& tags) {
  const bool contraflow = tags.one_way() && heading == Heading::against;
  const auto said = [&](const std::string& base, const auto& holds) {
    const std::string own = tags.value(tags.key_of(base, heading));
    return own.empty() ? !contraflow && holds(tags.value(base)) : holds(own);
  };
  for (const std::string name : {"bus", "psv", "taxi"}) {
    if (contraflow && name != "taxi" && tags.value("oneway:" + name) == "no") return true;
    if (said(name, some_word_lets_in) || said(name + ":lanes", some_word_lets_in) ||
        (name != "taxi" && said("lanes:" + name, counts_lanes)))
      return true;
  }
  return has_kerb_lane(heading, tags);
}

std::string key_of_buses(Heading heading, const WayTags& tags) {
  for (const char* name : {"bus", "psv", "taxi"})
    for (const std::string& key : {tags.key_of(name, heading), std::string(name)})
      if (const std::string word = tags.value(key); !word.empty()) {
        if (lets_in(access_of(word))) return key;
        break;
      }
  return {};
}

Access access_of_cars(Heading heading, const WayTags& tags) {
  return first_said({"motorcar", "motor_vehicle", "vehicle", "access"}, heading, tags)
      .value_or(usual_access(tags.value("highway")));
}

Access way_access(Heading heading, const WayTags& tags) {
  const Access cars = access_of_cars(heading, tags), usual = usual_access(tags.value("highway"));
  if (cars == Access::strange) return Access::all;
  const std::optional<Access> carpools = said_of("hov", heading, tags);
  if (cars == Access::all) {
    const std::string word = tags.value(tags.key_of("hov", heading));
    // A list says which lanes are those of carpools.
    const bool listed = !tags.value("hov:lanes").empty() ||
                        !tags.value("hov:lanes:forward").empty() ||
                        !tags.value("hov:lanes:backward").empty();
    return !listed && (word.empty() ? tags.value("hov") : word) == "designated" ? Access::carpool
                                                                                : Access::all;
  }
  if (!shuts_cars_out(cars)) return cars;
  const bool buses = !key_of_buses(heading, tags).empty() || lets_buses_in(heading, tags);
  // Buses drive through where cars of the owner alone may drive.
  if (buses || cars == Access::owners) return buses ? Access::bus : cars;
  // Cars alone are shut out: other motor traffic is not.
  if (said_of("motorcar", heading, tags) == Access::nobody &&
      first_said({"motor_vehicle", "vehicle", "access"}, heading, tags).value_or(usual) !=
          Access::nobody &&
      !first_said({"bus", "psv", "taxi"}, heading, tags))
    return Access::bus;
  if (carpools && lets_in(*carpools)) return Access::carpool;
  const std::optional<Access> every = said_of("access", heading, tags);
  const Access bicycles = first_said({"bicycle", "vehicle"}, heading, tags)
                              .value_or(every                    ? *every
                                        : usual == Access::cycle ? Access::all
                                                                 : usual);
  return lets_in(bicycles) ? Access::cycle : Access::nobody;
}

}  // namespace streetgen
