#include "traffic/ramp_lanes.hpp"

#include <unordered_map>

#include "traffic/lane_layout.hpp"

namespace streetgen {

namespace {

constexpr unsigned onwards = turn::through;
constexpr unsigned leftwards = turn::sharp_left | turn::left | turn::slight_left;
constexpr unsigned rightwards = turn::slight_right | turn::right | turn::sharp_right;

bool drives(const LaneWish& lane) {
  return lane.kind == LaneKind::general || lane.kind == LaneKind::bus;
}

RampLanes counted(const std::vector<LaneWish>& lanes) {
  RampLanes found;
  for (const LaneWish& lane : lanes) {
    if (!drives(lane)) continue;
    ++found.count;
    if (!(lane.turns & onwards)) continue;
    if (lane.turns & leftwards) ++found.parting_left;
    if (lane.turns & rightwards) ++found.parting_right;
  }
  return found;
}

// The mean width of the lanes that drive.
double lane_width(const AxisLanes& lanes, double width, const LaneSettings& settings) {
  const std::vector<LaneWish> all = across(lanes, settings.driving_side);
  const std::vector<double> shares = lane_shares(all, width, settings.narrowest);
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!drives(all[i])) continue;
    sum += (shares[i + 1] - shares[i]) * width;
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

}  // namespace

void count_ramp_lanes(RampRules& rules, const std::vector<StreetAxis>& axes,
                      const std::vector<LanesOfAxis>& lanes, const LaneSettings& settings) {
  if (rules.axes.empty()) return;
  rules.outer_side = settings.driving_side == DrivingSide::right ? -1 : +1;
  std::unordered_map<std::int64_t, const AxisLanes*> lanes_of;
  for (const LanesOfAxis& axis : lanes) lanes_of.emplace(axis.axis_id, &axis.lanes);
  std::unordered_map<std::int64_t, const StreetAxis*> axis_of;
  for (const StreetAxis& axis : axes) axis_of.emplace(axis.axis_id, &axis);
  for (RampAxis& ramp : rules.axes) {
    const auto found = lanes_of.find(ramp.axis_id);
    const auto axis = axis_of.find(ramp.axis_id);
    AxisLanes own = found != lanes_of.end() ? *found->second : AxisLanes{};
    if (own.forward.empty() && own.backward.empty() && own.both_ways.empty())
      own.forward.emplace_back();
    ramp.along = counted(own.forward);
    ramp.against = counted(own.backward);
    ramp.both_ways = !own.both_ways.empty();
    if (axis != axis_of.end()) ramp.lane_width = lane_width(own, axis->second->width, settings);
  }
}

}  // namespace streetgen
