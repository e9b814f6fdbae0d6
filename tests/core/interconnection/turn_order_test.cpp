// Lanes side by side turn in their order: nobody who turns to the near side crosses who goes on,
// and nobody who goes on crosses who turns to the far side.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <random>

#include "interconnection/joined_town.hpp"
#include "rounds.hpp"
#include "streetgen/osm_lanes.hpp"

namespace streetgen {
namespace turn_order_test {

const std::map<std::string, unsigned> bits{{"left", turn::left},
                                           {"slight_left", turn::slight_left},
                                           {"through", turn::through},
                                           {"slight_right", turn::slight_right},
                                           {"right", turn::right}};

unsigned turns_of(const std::string& words) {
  unsigned turns = 0;
  for (std::size_t from = 0; from < words.size();) {
    const std::size_t to = std::min(words.find(';', from), words.size());
    turns |= bits.at(words.substr(from, to - from));
    from = to + 1;
  }
  return turns;
}

// A way to a crossing, whose tags say of each lane where it leads, in order from left to right, and
// what lies at its kerbs.
class Ways {
 public:
  explicit Ways(unsigned seed) : random_(seed) {}

  int below(int count) { return static_cast<int>(random_() % count); }
  bool chance(double share) { return below(1000) < share * 1000; }

  OsmTags next() {
    OsmTags tags{{"highway", "secondary"}};
    const int left = below(3), right = below(3), through = left + right == 0 ? 1 : below(3);
    std::vector<std::string> words;
    words.insert(words.end(), left, chance(0.2) ? "slight_left" : "left");
    words.insert(words.end(), through, "through");
    words.insert(words.end(), right, chance(0.2) ? "slight_right" : "right");
    if (through == 0 && left > 0 && chance(0.5)) words[left - 1] += ";through";
    if (through > 0 && chance(0.3)) words[left] = (left > 0 ? "through" : "left;through");
    if (through > 1 && right == 0) words.back() += ";right";
    const bool one_way = chance(0.4);
    const int lanes = static_cast<int>(words.size()), back = one_way ? 0 : 1 + below(3);
    tags["lanes"] = std::to_string(lanes + back);
    if (one_way)
      tags["oneway"] = "yes";
    else
      tags["lanes:forward"] = std::to_string(lanes), tags["lanes:backward"] = std::to_string(back);
    std::string list = words.front();
    for (int i = 1; i < lanes; ++i) list += "|" + words[i];
    tags[one_way ? "turn:lanes" : "turn:lanes:forward"] = list;
    for (const char* base : {"cycleway", "parking"})
      for (const char* side : {":left", ":right"})
        if (chance(0.2)) tags[std::string(base) + side] = "lane";
    return tags;
  }

 private:
  std::mt19937 random_;
};

std::vector<LaneWish> wishes_of(const std::vector<OsmLane>& lanes) {
  std::vector<LaneWish> wishes;
  for (const OsmLane& lane : lanes)
    wishes.push_back({lane.kind, true, false, lane.width.value_or(0), 0, turns_of(lane.turn)});
  return wishes;
}

std::string written(const OsmTags& tags) {
  std::string text;
  for (const auto& [key, word] : tags) text += key + "=" + word + " ";
  return text;
}

// Of the lanes that cars drive on, from left to right: which marks reach farthest to either side.
void expect_marks_in_order(const std::vector<OsmLane>& lanes, const std::string& what) {
  unsigned before = 0;
  for (const OsmLane& lane : lanes) {
    if (!drives(lane.kind)) {
      EXPECT_EQ(lane.turn, "") << what;
      continue;
    }
    const unsigned turns = turns_of(lane.turn);
    EXPECT_FALSE(before & turn::rightwards && turns & (turn::leftwards | turn::through)) << what;
    EXPECT_FALSE(before & turn::through && turns & turn::leftwards) << what;
    before = turns;
  }
}

// Four streets about (0, 0), more or less at right angles; the first has the lanes of the way.
std::vector<LanedAxis> streets_about(Ways& ways, const OsmLanes& read) {
  std::vector<LanedAxis> roads;
  for (int i = 0; i < 4; ++i) {
    const double angle = M_PI + M_PI / 2 * i + 0.02 * (ways.below(21) - 10);
    const Line line{{100 * std::cos(angle), 100 * std::sin(angle), 0}, {0, 0, 0}};
    roads.push_back(road(i + 1, line, ways.below(3), 1 + ways.below(3)));
  }
  roads[0].forward = wishes_of(read.forward);
  roads[0].backward = wishes_of(read.backward);
  roads[0].width = 3.25 * static_cast<double>(roads[0].forward.size() + roads[0].backward.size());
  return roads;
}

// Of the streets to the left, straight on and to the right of the first one: 0, 1, 2.
int place_of(std::int64_t axis) { return static_cast<int>(4 - axis); }

class TurnOrder : public ::testing::TestWithParam<DrivingSide> {};

TEST_P(TurnOrder, IsThatOfTheLanes) {
  Ways ways(46);
  int crossed = 0, turned = 0;
  for (int round = 0; round < rounds(2000); ++round) {
    const OsmTags tags = ways.next();
    OsmLaneUse use;
    use.driving_side = GetParam();
    const OsmLanes read = read_osm_lanes(tags, use);
    const std::string what = written(tags);
    expect_marks_in_order(read.forward, what);
    const JoinedTown town(streets_about(ways, read), 8, GetParam());
    InterconnectionSettings settings;
    settings.driving_side = GetParam();
    // Of each lane of the way, from the left: the streets that it leads to.
    std::map<int, std::set<int>> led;
    for (const Interconnection& path : town.join({}, settings))
      if (path.plausible && town.axis_of(path.lane_in) == 1 && town.axis_of(path.lane_out) != 1 &&
          drives(town.lane(path.lane_in).kind))
        led[town.rank(path.lane_in)].insert(place_of(town.axis_of(path.lane_out)));
    for (auto lane = led.begin(); lane != led.end(); ++lane) {
      turned += static_cast<int>(lane->second.size());
      const auto next = std::next(lane);
      if (next == led.end()) continue;
      EXPECT_LE(*lane->second.rbegin(), *next->second.begin()) << what << "in round " << round;
      ++crossed;
    }
  }
  EXPECT_GT(turned, 2 * rounds(2000));
  EXPECT_GT(crossed, rounds(2000));
}

INSTANTIATE_TEST_SUITE_P(EitherSide, TurnOrder,
                         ::testing::Values(DrivingSide::right, DrivingSide::left));

}  // namespace turn_order_test
}  // namespace streetgen
