// Lanes, marks and paths are the same however streets are drawn, and mirrored where one drives on
// the other side.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "geometry/polyline.hpp"
#include "rounds.hpp"
#include "streetgen/interconnection.hpp"
#include "streetgen/lane.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {
namespace mirrored_traffic_test {

struct Network {
  std::vector<StreetAxis> axes;
  std::vector<LanesOfAxis> lanes;
};

class RandomNetwork {
 public:
  explicit RandomNetwork(unsigned seed) : random_(seed) {}

  // Arms about a crossing, some of which go on as others with other lanes.
  Network network() {
    Network out;
    const int arms = 3 + pick(3);
    for (int i = 0; i < arms; ++i) {
      double angle = 2 * M_PI * (i + 0.07 * pick(8)) / arms, reach = 0;
      Point from{};
      const int pieces = 1 + pick(3);
      for (int k = 0; k < pieces; ++k) {
        reach = 60 + pick(60);
        angle += 0.01 * (pick(21) - 10);
        const Point to = from + Point{reach * std::cos(angle), reach * std::sin(angle), 0};
        add(out, {from, to});
        from = to;
      }
    }
    return out;
  }

 private:
  int pick(int n) { return static_cast<int>(random_() % n); }

  std::vector<LaneWish> wishes(int count) {
    std::vector<LaneWish> lanes(count);
    const bool marks = pick(3) == 0;
    for (LaneWish& lane : lanes) {
      if (pick(8) == 0) lane.kind = pick(2) ? LaneKind::bus : LaneKind::cycle;
      if (pick(4) == 0) lane.width = 2.5 + 0.25 * pick(6);
      if (marks && drives(lane.kind))
        lane.turns = std::vector<unsigned>{turn::left, turn::through, turn::through | turn::right,
                                           turn::right, turn::merge_left, 0}[pick(6)];
    }
    return lanes;
  }

  void add(Network& out, const Line& line) {
    int forward = pick(4);
    const int backward = pick(4);
    if (forward + backward == 0) forward = 1;
    AxisLanes lanes{wishes(forward), wishes(backward)};
    if (pick(3) == 0) lanes.both_ways.resize(1);
    const auto id = static_cast<std::int64_t>(out.axes.size()) + 1;
    const double width =
        3.25 * static_cast<double>(forward + backward + lanes.both_ways.size()) + 0.1 * pick(10);
    StreetAxis axis{id, line, 0, width, width, 3 + 0.5 * pick(10), 1 + pick(5)};
    if (pick(4) == 0) axis.roadway_offset = 0.25 * (pick(9) - 4);
    out.axes.push_back(axis);
    out.lanes.push_back({id, lanes});
  }

  std::mt19937_64 random_;
};

unsigned swapped(unsigned turns) {
  unsigned out = turns & (turn::reverse | turn::through);
  for (const auto& [a, b] : {std::pair(turn::sharp_left, turn::sharp_right),
                             std::pair(turn::left, turn::right),
                             std::pair(turn::slight_left, turn::slight_right),
                             std::pair(turn::merge_left, turn::merge_right)})
    out |= (turns & a ? b : 0) | (turns & b ? a : 0);
  return out;
}

Network drawn_back(Network network, unsigned seed) {
  std::mt19937_64 random(seed);
  for (std::size_t i = 0; i < network.axes.size(); ++i) {
    if (random() % 2) continue;
    StreetAxis& axis = network.axes[i];
    AxisLanes& lanes = network.lanes[i].lanes;
    std::reverse(axis.line.begin(), axis.line.end());
    axis.roadway_offset = -axis.roadway_offset;
    std::swap(lanes.forward, lanes.backward);
    std::reverse(lanes.both_ways.begin(), lanes.both_ways.end());
  }
  return network;
}

Network mirrored(Network network) {
  for (StreetAxis& axis : network.axes) {
    for (Point& p : axis.line) p.y = -p.y;
    axis.roadway_offset = -axis.roadway_offset;
  }
  for (LanesOfAxis& of : network.lanes)
    for (std::vector<LaneWish>* list : {&of.lanes.forward, &of.lanes.backward, &of.lanes.both_ways}) {
      std::reverse(list->begin(), list->end());
      for (LaneWish& lane : *list) lane.turns = swapped(lane.turns);
    }
  return network;
}

// What traffic finds, in words that do not depend on how streets are drawn; in the mirror.
std::multiset<std::string> traffic(const Network& network, DrivingSide side, bool in_mirror) {
  const Streets town = streets(network.axes, {});
  LaneSettings lane_settings;
  lane_settings.driving_side = side;
  InterconnectionSettings settings;
  settings.driving_side = side;
  const std::vector<Lane> all = lanes(town, network.lanes, {}, lane_settings).lanes;
  std::multiset<std::string> found;
  const auto place = [&](const Point& p) {
    std::ostringstream out;
    out << std::llround(p.x * 1000 + 0.137) << ' '
        << std::llround((in_mirror ? -p.y : p.y) * 1000 + 0.137);
    return out.str();
  };
  for (const Lane& lane : all)
    for (const bool along : {true, false}) {
      if (!lane.both_ways && lane.along_axis != along) continue;
      std::ostringstream out;
      out << "lane from " << place(along ? lane.line.front() : lane.line.back()) << " to "
          << place(along ? lane.line.back() : lane.line.front()) << " kind "
          << static_cast<int>(lane.kind) << " turns "
          << (in_mirror ? swapped(lane.turns) : lane.turns) << " middle " << lane.middle
          << " width " << std::llround(lane.width * 1000 + 0.137);
      found.insert(out.str());
    }
  for (const Interconnection& i : interconnections(town, network.axes, all, {}, settings)) {
    std::ostringstream out;
    out << "path from " << place(i.line.front()) << " to " << place(i.line.back()) << " plausible "
        << i.plausible << ' ' << reason_name(i.reason);
    found.insert(out.str());
  }
  return found;
}

void expect_same(const std::multiset<std::string>& a, const std::multiset<std::string>& b,
                 const std::string& which) {
  std::vector<std::string> only_a, only_b;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(only_a));
  std::set_difference(b.begin(), b.end(), a.begin(), a.end(), std::back_inserter(only_b));
  EXPECT_TRUE(only_a.empty() && only_b.empty())
      << which << ", " << only_a.size() << " and " << only_b.size() << " differ: "
      << (only_a.empty() ? "-" : only_a.front()) << "; " << (only_b.empty() ? "-" : only_b.front());
}

TEST(MirroredTraffic, IsTheSameHoweverStreetsAreDrawn) {
  for (int seed = 1; seed <= rounds(500); ++seed) {
    const Network network = RandomNetwork(seed).network();
    expect_same(traffic(network, DrivingSide::right, false),
                traffic(drawn_back(network, seed), DrivingSide::right, false),
                "seed " + std::to_string(seed));
  }
}

TEST(MirroredTraffic, IsTheMirrorImageWhereOneDrivesOnTheOtherSide) {
  for (int seed = 1; seed <= rounds(500); ++seed) {
    const Network network = RandomNetwork(seed).network();
    expect_same(traffic(network, DrivingSide::right, false),
                traffic(mirrored(network), DrivingSide::left, true),
                "seed " + std::to_string(seed));
  }
}

}  // namespace mirrored_traffic_test
}  // namespace streetgen
