#include "osm/placement.hpp"

#include <cmath>

namespace streetgen {

namespace {

constexpr double farthest = 100;  // metres

struct Mark {
  double share = 0;  // of the width of the lane, from its left
  int lane = 0;      // from 1
};

std::optional<Mark> mark_of(const std::string& word) {
  for (const auto& [name, share] :
       {std::pair("left_of:", 0.0), std::pair("middle_of:", 0.5), std::pair("right_of:", 1.0)}) {
    const std::string start = name;
    if (word.compare(0, start.size(), start) != 0) continue;
    const std::string number = word.substr(start.size());
    if (number.empty() || number.size() > 2 ||
        number.find_first_not_of("0123456789") != number.npos)
      return std::nullopt;
    return Mark{share, std::stoi(number)};
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> placed_offset(const WayLanes& lanes, const OsmLaneUse& use, WayTags& tags) {
  // The lanes from left to right as those see them who drive along.
  struct Across {
    const OsmLane* lane;
    Heading heading;
    double width;
  };
  static const OsmLane of_both{};
  std::vector<Across> across;
  const auto along = [&] {
    for (const OsmLane& lane : lanes.along.lanes) across.push_back({&lane, Heading::along, 0});
  };
  const auto against = [&] {
    for (auto lane = lanes.against.lanes.rbegin(); lane != lanes.against.lanes.rend(); ++lane)
      across.push_back({&*lane, Heading::against, 0});
  };
  if (lanes.side == DrivingSide::right)
    against();
  else
    along();
  for (int i = 0; i < lanes.middle; ++i) across.push_back({&of_both, Heading::along, 0});
  if (lanes.side == DrivingSide::right)
    along();
  else
    against();

  double known = 0, total = 0;
  int open = 0;
  for (Across& each : across) {
    each.width =
        each.lane->width.value_or(each.lane->kind == LaneKind::cycle     ? use.cycle_lane_width
                                  : each.lane->kind == LaneKind::parking ? use.parking_lane_width
                                                                         : 0);
    known += each.width;
    if (each.width == 0) ++open;
  }
  const double rest = use.roadway_width
                          ? std::max((*use.roadway_width - known) / std::max(open, 1), 0.0)
                          : use.lane_width;
  for (Across& each : across) {
    if (each.width == 0) each.width = rest;
    total += each.width;
  }

  std::optional<double> offset;
  for (const Heading heading : {Heading::along, Heading::against}) {
    const std::string key = tags.said_of("placement", heading), word = tags.value(key);
    if (word.empty() || word == "transition") continue;
    const std::optional<Mark> mark = mark_of(word);
    std::vector<std::size_t> counted;  // places of the lanes that the tag counts, from their left
    for (std::size_t i = 0; i < across.size(); ++i)
      if (across[i].lane != &of_both && across[i].heading == heading && across[i].lane->listed)
        counted.push_back(i);
    if (heading == Heading::against) std::reverse(counted.begin(), counted.end());
    if (!mark || mark->lane < 1 || mark->lane > static_cast<int>(counted.size())) {
      tags.name(key,
                mark ? "there is no such lane" : "it is no left_of, middle_of or right_of a lane");
      continue;
    }
    if (offset) continue;
    const std::size_t place = counted[mark->lane - 1];
    double x = (heading == Heading::along ? mark->share : 1 - mark->share) * across[place].width;
    for (std::size_t i = 0; i < place; ++i) x += across[i].width;
    const double found = (x - total / 2) * (tags.drawn_against() ? -1 : 1);
    if (std::abs(found) > farthest)
      tags.name(key, "it puts the way more than 100 m beside the middle of its lanes");
    else
      offset = found;
  }
  if (!tags.one_way() && !tags.value("placement").empty() &&
      tags.value("placement") != "transition")
    tags.name("placement", "it says no direction of a street of both");
  return offset;
}

}  // namespace streetgen
