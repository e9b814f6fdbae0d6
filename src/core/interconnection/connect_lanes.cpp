#include "interconnection/connect_lanes.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"
#include "interconnection/merging_way.hpp"
#include "interconnection/turn.hpp"
#include "lane/lane_succession.hpp"

namespace streetgen {

namespace {

// lanes[i] goes on to goals[i + shift].
int goal(const Group& goals, int i, int shift) {
  return goals[std::clamp(i + shift, 0, static_cast<int>(goals.size()) - 1)];
}

bool straight_on(const Ways& of_node, const Way& way) {
  return turn_of(way.angle) == Turn::through || goes_on_alone(of_node, way);
}

// Lanes that others enter from one side are left to them; else lanes go on as they lie.
int shift_straight_on(const Ways& of_node, const Way& way, const Group& lanes) {
  const int more = static_cast<int>(way.goals.size()) - static_cast<int>(lanes.size());
  if (more > 0)
    if (const auto from_left = entered_from_left(of_node, way)) return *from_left ? more : 0;
  const auto abreast = [](const std::vector<LaneEnd>& ends, const Group& group) {
    std::vector<LaneAbreast> found;
    for (const int i : group) found.push_back({ends[i].turns, ends[i].aside});
    return found;
  };
  return succession(abreast(way.from->in, lanes), abreast(way.to->out, way.goals),
                    DrivingSide::right);
}

// Whether the lanes beside the other direction are the left ones.
bool inner_left(const Way& way) {
  const auto &in = way.from->in, &out = way.to->out;
  return distance(in.front().place, out.front().place) <=
         distance(in.back().place, out.back().place);
}

// Along the kerb that it turns about, or as near to it as the radius allows.
int shift_of_turn(const Way& way, const Group& lanes) {
  const int n = static_cast<int>(lanes.size()), m = static_cast<int>(way.goals.size());
  const int low = std::min(0, m - n), high = std::max(0, m - n);
  const bool left = way.turns_back() ? inner_left(way) : way.angle > 0;
  const int first = left ? 0 : m - n, side = left ? 1 : -1;
  for (int shift = first; shift >= low && shift <= high; shift += side) {
    bool fits = true;
    for (int i = 0; i < n; ++i) fits = fits && !way.tight(lanes[i], goal(way.goals, i, shift));
    if (fits) return shift;
  }
  return first;
}

// The goal nearest to a lane of those that fit; -1: there is none.
template <class Fits>
int nearest_goal(const Way& way, int wanted, Fits fits) {
  int best = -1;
  for (const int o : way.goals)
    if (fits(o) && (best < 0 || std::abs(o - wanted) < std::abs(best - wanted))) best = o;
  return best;
}

// The general lane nearest to a carpool lane in which a general lane goes on; -1: none is needed.
int open_beside(const Way& way, int in, int reached) {
  const auto general = [](const LaneEnd& lane) { return lane.kind == LaneKind::general; };
  if (!general(way.from->in[in]) || way.to->out[reached].kind != LaneKind::carpool) return -1;
  return nearest_goal(way, reached,
                      [&](int o) { return general(way.to->out[o]) && !way.tight(in, o); });
}

// In the place of a lane that no car comes to, the nearest one where the turn is wide enough, else
// where it has no corner.
int drivable_goal(const Way& way, int in, int wanted) {
  if (way.drivable(in, wanted)) return wanted;
  const int wide = nearest_goal(way, wanted, [&](int o) { return !way.tight(in, o); });
  if (wide >= 0) return wide;
  const int tight = nearest_goal(way, wanted, [&](int o) { return way.drivable(in, o); });
  return tight < 0 ? wanted : tight;
}

}  // namespace

void connect_lanes(const Ways& of_node, Way way, const Group& lanes, Reason reason) {
  leave_to_main(of_node, way);
  const int shift = straight_on(of_node, way) ? shift_straight_on(of_node, way, lanes)
                                              : shift_of_turn(way, lanes);
  for (int i = 0; i < static_cast<int>(lanes.size()); ++i) {
    const int reached = drivable_goal(way, lanes[i], goal(way.goals, i, shift));
    way.at(lanes[i], reached) = {true, reason};
    const int open = open_beside(way, lanes[i], reached);
    if (open >= 0) way.at(lanes[i], open) = {true, reason};
  }
}

}  // namespace streetgen
