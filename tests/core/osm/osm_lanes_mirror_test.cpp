// A way that is drawn the other way round, and the street of a country that drives on the left, have
// the same lanes, turned or mirrored.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "streetgen/osm_lanes.hpp"

namespace streetgen {
namespace osm_lanes_mirror_test {

using Random = std::mt19937;

std::string swapped(std::string text, const std::string& a, const std::string& b) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    if (text.compare(i, a.size(), a) == 0) {
      result += b;
      i += a.size();
    } else if (text.compare(i, b.size(), b) == 0) {
      result += a;
      i += b.size();
    } else {
      result += text[i++];
    }
  }
  return result;
}

OsmTags turned(const OsmTags& tags) {
  OsmTags result;
  for (const auto& [key, word] : tags) {
    const std::string other = swapped(swapped(key, ":forward", ":backward"), ":left", ":right");
    const bool is_oneway = key == "oneway" || (key.size() > 7 && key.substr(key.size() - 7) == ":oneway");
    result[other] = is_oneway ? swapped(word, "yes", "-1") : word;
  }
  return result;
}

std::string reversed_list(const std::string& list) {
  std::vector<std::string> words{""};
  for (const char letter : list) {
    if (letter == '|')
      words.emplace_back();
    else
      words.back() += letter;
  }
  std::string result;
  for (auto word = words.rbegin(); word != words.rend(); ++word)
    result += (word == words.rbegin() ? "" : "|") + *word;
  return result;
}

// A placement counts the listed lanes of its direction from the left: in the mirror, from the right.
std::string mirrored_placement(const std::string& word, int lane_count) {
  const std::size_t colon = word.find(':');
  return swapped(word.substr(0, colon + 1), "left", "right") +
         std::to_string(lane_count + 1 - std::stoi(word.substr(colon + 1)));
}

OsmTags mirrored(const OsmTags& tags, int lane_count) {
  OsmTags result;
  for (const auto& [key, word] : tags) {
    const bool list = key.find(":lanes") != std::string::npos;
    const bool placement = key.rfind("placement", 0) == 0;
    result[swapped(key, ":left", ":right")] =
        list        ? swapped(reversed_list(word), "left", "right")
        : placement ? mirrored_placement(word, lane_count)
                    : word;
  }
  return result;
}

std::string text_of(const std::vector<OsmLane>& lanes, bool mirror) {
  std::string text;
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    const OsmLane& lane = lanes[mirror ? lanes.size() - 1 - i : i];
    const auto word = [&](const std::string& said) {
      return mirror ? swapped(said, "left", "right") : said;
    };
    text += std::to_string(static_cast<int>(lane.kind)) + word(lane.turn) + "/" +
            word(lane.change) + "=" + std::to_string(lane.width.value_or(0)) + " ";
  }
  return text;
}

enum class As { it_is, turned, mirrored };

struct Seen {
  std::string forward, backward;
  WayDirection direction;
  bool forward_known, backward_known;
  int both_ways, lane_count;
  double offset;
  std::vector<std::string> unread;
};

// What is read of a street, as somebody tells it who sees it as it is.
Seen seen(const OsmTags& tags, As as) {
  OsmLaneUse use;
  use.usual_lanes = 2;
  const OsmLanes straight = read_osm_lanes(tags, use);
  const int listed = static_cast<int>(std::count_if(straight.forward.begin(), straight.forward.end(),
                                                    [](const OsmLane& lane) { return lane.listed; }));
  if (as == As::mirrored) use.driving_side = DrivingSide::left;
  const auto changed = [&](const OsmTags& some) {
    return as == As::turned ? turned(some) : as == As::mirrored ? mirrored(some, listed) : some;
  };
  OsmLanes lanes = read_osm_lanes(changed(tags), use);
  if (as == As::turned) {
    std::swap(lanes.forward, lanes.backward);
    std::swap(lanes.forward_known, lanes.backward_known);
    if (lanes.direction != WayDirection::both)
      lanes.direction = lanes.direction == WayDirection::direct ? WayDirection::reverse
                                                                : WayDirection::direct;
  }
  Seen seen{text_of(lanes.forward, as == As::mirrored),
            text_of(lanes.backward, as == As::mirrored),
            lanes.direction,
            lanes.forward_known,
            lanes.backward_known,
            lanes.both_ways,
            lanes.lane_count.value_or(0),
            (as == As::it_is ? 1 : -1) * lanes.roadway_offset.value_or(0),
            {}};
  for (const UnreadTag& tag : lanes.unread) {
    OsmTags key{{tag.key, as == As::mirrored ? "middle_of:1" : ""}};
    seen.unread.push_back(changed(key).begin()->first);
  }
  std::sort(seen.unread.begin(), seen.unread.end());
  return seen;
}

// Tags of a way whose lists and counts agree.
class Ways {
 public:
  explicit Ways(unsigned seed) : random_(seed) {}

  OsmTags next() {
    tags_.clear();
    const bool one_way = chance(0.5);
    if (one_way) tags_["oneway"] = "yes";
    const int forward = 1 + below(4), backward = one_way ? 0 : 1 + below(3);
    const int middle = !one_way && chance(0.2) ? 1 : 0;
    const bool counted = chance(0.8);
    if (counted) tags_["lanes"] = std::to_string(forward + backward + middle);
    if (middle > 0) tags_["lanes:both_ways"] = "1";
    if (!one_way && (!counted || chance(0.5))) {
      tags_["lanes:forward"] = std::to_string(forward);
      tags_["lanes:backward"] = std::to_string(backward);
    }
    list_lanes(one_way ? ":lanes" : ":lanes:forward", forward);
    if (!one_way) list_lanes(":lanes:backward", backward);
    for (const char* base : {"cycleway", "busway", "parking"})
      for (const char* side : {":left", ":right"})
        if (chance(0.2)) kerb_lane(std::string(base) + side);
    if (chance(0.1)) tags_["cycleway"] = "lane";
    if (chance(0.2)) tags_["cycleway:left:oneway"] = any({"-1", "no", "yes"});
    if (one_way && chance(0.2)) tags_["oneway:bicycle"] = "no";
    if (one_way && chance(0.2)) tags_["oneway:bus"] = "no";
    if (chance(0.2)) tags_["lanes:psv:forward"] = "1";
    if (chance(0.2)) {
      const std::string word = any({"left_of:", "middle_of:", "right_of:"});
      tags_[one_way ? "placement" : "placement:forward"] = word + std::to_string(1 + below(forward));
    }
    if (chance(0.2)) tags_["width"] = any({"9", "12.5", "30 ft"});
    let_in(one_way);
    return tags_;
  }

 private:
  bool chance(double share) { return below(1000) < share * 1000; }
  int below(int count) { return static_cast<int>(random_() % count); }
  std::string any(const std::vector<std::string>& words) { return words[below(words.size())]; }

  std::string words(int count, const std::vector<std::string>& known) {
    std::string list = any(known);
    for (int i = 1; i < count; ++i) list += "|" + any(known);
    return list;
  }

  void kerb_lane(const std::string& key) {
    tags_[key] = "lane";
    if (key.rfind("busway", 0) != 0 && chance(0.4)) tags_[key + ":width"] = any({"1.75", "2 m", "6 ft"});
    if (key.rfind("parking", 0) == 0 && chance(0.4))
      tags_[key + ":orientation"] = any({"parallel", "diagonal", "perpendicular"});
  }

  // Who may drive, on all lanes or on those of a direction.
  void let_in(bool one_way) {
    const std::string heading = one_way ? "" : any({"", ":forward", ":backward"});
    if (chance(0.1)) tags_["access" + heading] = any({"no", "private", "destination"});
    if (chance(0.1)) tags_["motor_vehicle" + heading] = any({"no", "delivery"});
    if (chance(0.1)) tags_[any({"bus", "psv"}) + heading] = any({"yes", "designated"});
    if (chance(0.05)) tags_["hov"] = "designated";
  }

  // Lists of all lanes: those for cars, and now and then one for bicycles.
  void list_lanes(const std::string& suffix, int cars) {
    const int cycle = chance(0.3) ? below(cars + 1) : -1, all = cars + (cycle >= 0 ? 1 : 0);
    if (cycle >= 0) {
      std::string vehicle, bicycle;
      for (int i = 0; i < all; ++i) {
        vehicle += std::string(i ? "|" : "") + (i == cycle ? "no" : "yes");
        bicycle += std::string(i ? "|" : "") + (i == cycle ? "designated" : "yes");
      }
      tags_["vehicle" + suffix] = vehicle;
      tags_["bicycle" + suffix] = bicycle;
    }
    if (chance(0.4)) tags_["turn" + suffix] = words(all, {"left", "through", "right", "", "slight_left;through"});
    if (chance(0.2)) tags_["width" + suffix] = words(all, {"3", "3.5", ""});
    if (chance(0.2)) tags_["change" + suffix] = words(all, {"yes", "no", "not_left", "only_right"});
    if (chance(0.1)) tags_["hov" + suffix] = words(all, {"", "designated"});
    if (chance(0.2)) tags_["bus" + suffix] = words(all, {"", "yes", "designated"});
  }

  Random random_;
  OsmTags tags_;
};

std::string written(const OsmTags& tags) {
  std::string text;
  for (const auto& [key, word] : tags) text += key + "=" + word + " ";
  return text;
}

TEST(OsmLanesMirror, FiveHundredWays) {
  Ways ways(45);
  int read = 0;
  for (int i = 0; i < 500; ++i) {
    const OsmTags tags = ways.next();
    const Seen straight = seen(tags, As::it_is);
    if (straight.unread.empty()) ++read;
    for (const As as : {As::turned, As::mirrored}) {
      const Seen other = seen(tags, as);
      const std::string what = (as == As::turned ? "turned: " : "mirrored: ") + written(tags);
      EXPECT_EQ(other.forward, straight.forward) << what;
      EXPECT_EQ(other.backward, straight.backward) << what;
      EXPECT_EQ(other.direction, straight.direction) << what;
      EXPECT_EQ(other.forward_known, straight.forward_known) << what;
      EXPECT_EQ(other.backward_known, straight.backward_known) << what;
      EXPECT_EQ(other.both_ways, straight.both_ways) << what;
      EXPECT_EQ(other.lane_count, straight.lane_count) << what;
      EXPECT_NEAR(other.offset, straight.offset, 1e-9) << what;
      EXPECT_EQ(other.unread, straight.unread) << what;
    }
  }
  EXPECT_GT(read, 250) << "most of the tags agree";
}

}  // namespace osm_lanes_mirror_test
}  // namespace streetgen
