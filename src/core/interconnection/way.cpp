#include "interconnection/way.hpp"

#include <algorithm>
#include <cmath>

#include "interconnection/movement_angle.hpp"

namespace streetgen {

namespace {

constexpr double noticeable = 20;         // degrees: a path that turns less has no tight radius
constexpr double most_off_course = 45;    // degrees, of a way that may be the one straight on
constexpr double importance_weight = 10;  // degrees that a step of importance is worth

}  // namespace

Group group_of(const std::vector<LaneEnd>& lanes, LaneKind kind) {
  Group group;
  for (int i = 0; i < static_cast<int>(lanes.size()); ++i)
    if (leads_as(lanes[i].kind) == kind && !lanes[i].middle) group.push_back(i);
  return group;
}

Group middle_of(const std::vector<LaneEnd>& lanes) {
  Group group;
  for (int i = 0; i < static_cast<int>(lanes.size()); ++i)
    if (lanes[i].middle) group.push_back(i);
  return group;
}

Group targets(const Leg& leg, LaneKind kind) {
  Group same = group_of(leg.out, kind);
  return same.empty() && kind != LaneKind::general ? group_of(leg.out, LaneKind::general) : same;
}

bool Way::forbidden(int in, int out) const {
  return movement->forbidden(from->in[in].kind, to->out[out].kind);
}

bool Way::tight(int in, int out) const {
  return !drivable(in, out) ||
         (std::abs(angle) > noticeable && movement->radius[pair(in, out)] < movement->least_radius);
}

bool Way::nearly_straight() const { return in_steps(std::abs(angle)) <= in_steps(most_off_course); }

long long Way::off_course() const {
  return in_steps(std::abs(angle) +
                  importance_weight * std::abs(to->importance - from->importance));
}

Ways ways_of(const std::vector<Leg>& legs, std::vector<Movement>& movements) {
  Ways ways;
  for (Movement& movement : movements) {
    const Leg &from = legs[movement.from], &to = legs[movement.to];
    movement.verdicts.resize(from.in.size() * to.out.size());
    ways.push_back({&movement, &from, &to, movement_angle(from, to),
                    movement_order(from, to) + 360 * movement.side});
  }
  return ways;
}

int way_through(const Ways& ways) {
  int best = -1;
  long long least = 0;
  for (int j = 0; j < static_cast<int>(ways.size()); ++j) {
    if (!ways[j].nearly_straight()) continue;
    const long long cost = ways[j].off_course();
    if (best >= 0 && cost >= least) continue;
    least = cost;
    best = j;
  }
  return best;
}

bool goes_on_alone(const Ways& of_node, const Way& way) {
  return !way.turns_back() && std::all_of(of_node.begin(), of_node.end(), [&](const Way& other) {
    return other.movement == way.movement || other.turns_back() ||
           (other.from != way.from && other.to != way.to);
  });
}

}  // namespace streetgen
