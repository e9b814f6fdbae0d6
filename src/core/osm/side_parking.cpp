#include "osm/side_parking.hpp"

#include "osm/lane_list.hpp"

namespace streetgen {

namespace {

constexpr int most_cars = 1000;  // on one side of a way
constexpr std::size_t longest_count = 4;
constexpr std::initializer_list<const char*> ways_to_stand = {"perpendicular", "diagonal",
                                                              "parallel", "marked"};
constexpr std::initializer_list<const char*> none_stands = {
    "no", "none", "no_parking", "no_stopping", "no_standing", "fire_lane"};
constexpr std::initializer_list<const char*> ways_to_turn = {"perpendicular", "diagonal",
                                                             "parallel"};

// Of several places a lane, which the reader of lanes makes, else the first that is known.
std::string place_among(const std::string& said, std::initializer_list<const char*> on_lane) {
  if (is_among(word_among(said, on_lane), on_lane)) return "lane";
  const std::string place = word_among(said, {"street_side", "lay_by", "half_on_kerb", "on_kerb"});
  return place == "lay_by" ? "street_side" : place;
}

// What the older scheme says of where cars stand, beneath the way in which they do.
std::string place_of_older(const std::string& key, WayTags& tags) {
  const std::string place =
      place_among(tags.value(key), {"on_street", "lane", "painted_area_only"});
  return place.empty() ? "lane" : place;
}

std::optional<int> capacity_of(const std::string& key, WayTags& tags) {
  const std::string said = tags.value(key);
  if (said.empty()) return std::nullopt;
  if (said.size() <= longest_count && said.find_first_not_of("0123456789") == said.npos)
    if (const int cars = std::stoi(said); cars <= most_cars) return cars;
  tags.name(key, "it is no number of cars up to 1000");
  return std::nullopt;
}

}  // namespace

OsmSideParking side_parking(const std::string& side, WayTags& tags) {
  OsmSideParking parking;
  const auto first_of = [&](const std::string& base, const std::string& end) {
    const std::string own = base + ":" + side + end;
    return tags.value(own).empty() ? base + ":both" + end : own;
  };
  const std::string older = first_of("parking:lane", "");
  const std::string stands = word_among(tags.value(older), ways_to_stand);
  const std::string newer = first_of("parking", "");
  const std::string said = place_among(tags.value(newer), {"lane"});
  if (is_among(said, {"separate", "shoulder"}))
    tags.name(newer, said == "separate" ? "the source draws where cars stand apart from the street"
                                        : "no bay is made on a shoulder");
  else if (said.empty() && stands == "separate")
    tags.name(older, "the source draws where cars stand apart from the street");
  if (is_among(said, {"no", "none"}) || (said.empty() && is_among(stands, none_stands)))
    parking.place = "no";
  else if (said.empty() && is_among(stands, ways_to_stand))
    parking.place = place_of_older(older + ":" + stands, tags);
  else
    parking.place = said;
  const std::optional<int> cars = capacity_of(first_of("parking", ":capacity"), tags);
  if (!is_among(parking.place, {"lane", "street_side", "half_on_kerb", "on_kerb"})) {
    if (parking.place != "no") parking.place.clear();
    return parking;
  }
  parking.capacity = cars;
  if (parking.place == "lane") {
    // The lane says the rest.
    if (!parking.capacity) parking.place.clear();
    return parking;
  }
  const std::string turned = first_of("parking", ":orientation");
  parking.orientation =
      word_among(tags.value(turned).empty() ? stands : tags.value(turned), ways_to_turn);
  if (!is_among(parking.orientation, ways_to_turn)) parking.orientation.clear();
  const std::string wide = first_of("parking", ":width");
  if (const std::string width = tags.value(wide); !width.empty()) {
    parking.depth = lane_width_of(width, LaneKind::parking);
    if (!parking.depth) tags.name(wide, "it is no width of a lane");
  }
  return parking;
}

}  // namespace streetgen
