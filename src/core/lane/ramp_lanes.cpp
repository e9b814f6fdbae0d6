#include "lane/ramp_lanes.hpp"

#include <unordered_map>

#include "lane/lane_layout.hpp"

namespace streetgen {

namespace {

constexpr unsigned onwards = turn::through;

// The lanes of one direction.
RampLanes counted(const std::vector<LaneWish>& lanes, bool along_axis) {
  RampLanes found;
  for (const LaneWish& lane : lanes) {
    if (!drives(lane.kind) || lane.along_axis != along_axis) continue;
    ++found.count;
    if (!(lane.turns & onwards)) continue;
    if (lane.turns & turn::leftwards) ++found.parting_left;
    if (lane.turns & turn::rightwards) ++found.parting_right;
  }
  return found;
}

// The mean width of the lanes that drive.
double lane_width(const std::vector<LaneWish>& lanes, double width, double narrowest) {
  const std::vector<double> shares = lane_shares(lanes, width, narrowest);
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    if (!drives(lanes[i].kind)) continue;
    sum += (shares[i + 1] - shares[i]) * width;
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

}  // namespace

void count_ramp_lanes(RampRules& rules, const std::vector<StreetAxis>& axes, LaneWishes wishes,
                      const LaneSettings& settings) {
  rules.outer_side = settings.driving_side == DrivingSide::right ? -1 : +1;
  std::unordered_map<std::int64_t, double> widths;
  for (const StreetAxis& axis : axes) widths.emplace(axis.axis_id, axis.width);
  rules.lanes_of = [widths = std::move(widths), wishes = std::move(wishes),
                    narrowest = settings.narrowest](const Edge& edge) {
    const std::vector<LaneWish> lanes = wishes.of(edge).lanes;
    RampEdgeLanes found{counted(lanes, true), counted(lanes, false)};
    for (const LaneWish& lane : lanes) found.both_ways |= lane.both_ways;
    found.lane_width = lane_width(lanes, widths.at(edge.axis_id), narrowest);
    return found;
  };
}

}  // namespace streetgen
