#include "traffic/junction_route.hpp"

#include <algorithm>
#include <limits>

#include "geometry/polyline.hpp"

namespace streetgen {

namespace {

constexpr int none = -1;

// Of a number of an edge inside and its direction.
RoutePiece piece_of(int state) { return {state / 2, state % 2 == 0}; }

}  // namespace

JunctionRoutes::JunctionRoutes(const JunctionPlace& place, double node_tolerance, bool obeyed)
    : place_(place), node_tolerance_(node_tolerance), obeyed_(obeyed) {}

double JunctionRoutes::size(int inner) const { return length(place_.inner[inner].line); }

bool JunctionRoutes::allowed(int node, std::int64_t from_axis, std::int64_t to_axis) const {
  if (!obeyed_) return true;
  bool only = false, named = false;
  for (const TurnRestriction& r : place_.restrictions) {
    // One with a turn or an exception speaks of some of the ways or lanes.
    if (r.from_axis != from_axis || r.turn || !r.except.empty() ||
        distance(r.via, place_.nodes[node]) > 3 * node_tolerance_)
      continue;
    if (!r.only && r.to_axis == to_axis) return false;
    only = only || r.only;
    named = named || (r.only && r.to_axis == to_axis);
  }
  return !only || named;
}

std::optional<JunctionRoute> JunctionRoutes::between(int from_leg, int to_leg) const {
  const JunctionLeg &from = place_.legs[from_leg], &to = place_.legs[to_leg];
  const int states = 2 * static_cast<int>(place_.inner.size());
  const double never = std::numeric_limits<double>::infinity();
  if (from.node == to.node && allowed(from.node, from.axis_id, to.axis_id)) return JunctionRoute{};
  std::vector<double> cost(states, never);
  std::vector<int> before(states, none);
  std::vector<bool> done(states);
  const auto first_node = [&](int s) {
    const InnerEdge& edge = place_.inner[s / 2];
    return s % 2 == 0 ? edge.from_node : edge.to_node;
  };
  const auto last_node = [&](int s) { return first_node(s ^ 1); };
  const auto open = [&](int s) {
    return s % 2 == 0 ? place_.inner[s / 2].along : place_.inner[s / 2].against;
  };
  for (int s = 0; s < states; ++s)
    if (open(s) && first_node(s) == from.node &&
        allowed(from.node, from.axis_id, place_.inner[s / 2].axis_id))
      cost[s] = size(s / 2);
  while (true) {
    int best = none;
    for (int s = 0; s < states; ++s)
      if (!done[s] && cost[s] < never && (best == none || cost[s] < cost[best])) best = s;
    if (best == none) return std::nullopt;
    done[best] = true;
    const int node = last_node(best);
    const std::int64_t axis = place_.inner[best / 2].axis_id;
    if (node == to.node && allowed(node, axis, to.axis_id)) {
      JunctionRoute route;
      for (int s = best; s != none; s = before[s]) route.push_back(piece_of(s));
      std::reverse(route.begin(), route.end());
      return route;
    }
    for (int s = 0; s < states; ++s) {
      if (s / 2 == best / 2 || !open(s) || first_node(s) != node ||
          !allowed(node, axis, place_.inner[s / 2].axis_id))
        continue;
      const double reached = cost[best] + size(s / 2);
      if (reached >= cost[s]) continue;
      cost[s] = reached;
      before[s] = best;
    }
  }
}

}  // namespace streetgen
