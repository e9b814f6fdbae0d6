#include "interconnection/next_junction.hpp"

#include <algorithm>
#include <climits>
#include <limits>

#include "geometry/polyline.hpp"
#include "interconnection/plausibility.hpp"
#include "interconnection/turning_back.hpp"

namespace streetgen {

namespace {

constexpr double seen_along = 10;  // metres of an edge by which it is seen where it leads

bool runs(const LaneWish& lane, bool along_axis) {
  return carries_traffic(lane.kind) && (lane.both_ways || lane.along_axis == along_axis);
}

}  // namespace

bool leave_choice(const std::vector<LaneWish>& lanes, bool along_axis) {
  return std::count_if(lanes.begin(), lanes.end(), [&](const LaneWish& lane) {
           return runs(lane, along_axis) && leads_as(lane.kind) == LaneKind::general;
         }) > 1;
}

Leg foreseen_leg(const Edge& edge, bool at_start, const std::vector<LaneWish>& lanes) {
  const double total = length(edge.line), along = std::min(seen_along, total);
  const auto at = position_at(edge.line, at_start ? along : total - along);
  const Point node = planar(at_start ? edge.line.front() : edge.line.back());
  Leg leg;
  leg.stand = planar(at.point);
  leg.course = leg.outset = unit(leg.stand - node);
  for (const LaneWish& lane : lanes)
    for (const bool out : {true, false}) {
      if (!runs(lane, at_start == out)) continue;
      LaneEnd end{leads_as(lane.kind) == LaneKind::general ? LaneKind::general : lane.kind,
                  lane.turns, leg.stand, leg.course * (out ? 1 : -1)};
      (out ? leg.out : leg.in).push_back(end);
    }
  std::reverse((at_start ? leg.in : leg.out).begin(), (at_start ? leg.in : leg.out).end());
  return leg;
}

std::vector<Movement> foreseen_movements(const std::vector<Leg>& legs, int from) {
  std::vector<Movement> movements;
  for (int to = 0; to < static_cast<int>(legs.size()); ++to) {
    if (to == from || legs[to].out.empty()) continue;
    const std::size_t pairs = legs[from].in.size() * legs[to].out.size();
    Movement movement;
    movement.from = from;
    movement.to = to;
    movement.turns_back = turns_back(legs, from, to);
    movement.radius.assign(pairs, std::numeric_limits<double>::infinity());
    movement.drivable.assign(pairs, true);
    movements.push_back(std::move(movement));
  }
  return movements;
}

std::vector<unsigned> served_ahead(const std::vector<Leg>& legs, int from,
                                   std::vector<Movement>& movements, DrivingSide driving_side) {
  choose_lanes(legs, movements, driving_side);
  std::vector<unsigned> served(legs[from].in.size());
  for (const Movement& movement : movements) {
    const std::vector<LaneEnd>& out = legs[movement.to].out;
    if (movement.turns_back || movement.to >= static_cast<int>(sizeof(unsigned) * CHAR_BIT))
      continue;
    for (std::size_t p = 0; p < movement.verdicts.size(); ++p) {
      const Verdict& verdict = movement.verdicts[p];
      if (verdict.plausible && verdict.traffic.none() && verdict.reason != Reason::only_way &&
          leads_as(out[p % out.size()].kind) == LaneKind::general)
        served[p / out.size()] |= 1U << movement.to;
    }
  }
  return served;
}

}  // namespace streetgen
