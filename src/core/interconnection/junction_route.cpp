#include "interconnection/junction_route.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <queue>
#include <utility>

#include "geometry/polyline.hpp"
#include "interconnection/turn.hpp"

namespace streetgen {

namespace {

constexpr int none = -1;

// The piece of route that a state stands for: an edge inside and its direction.
RoutePiece piece_of(int state) { return {state / 2, state % 2 == 0}; }

Point heading(const Point& from, const Point& to) { return unit(planar(to) - planar(from)); }

template <typename Restriction>
std::vector<Restriction> binding(const std::vector<Restriction>& restrictions,
                                 std::optional<LaneKind> kind) {
  std::vector<Restriction> found;
  if (!kind) return found;
  for (const Restriction& r : restrictions)
    if (std::find(r.except.begin(), r.except.end(), *kind) == r.except.end()) found.push_back(r);
  return found;
}

}  // namespace

JunctionRoutes::JunctionRoutes(const JunctionPlace& place, double node_tolerance,
                               std::optional<LaneKind> kind)
    : place_(place),
      node_tolerance_(node_tolerance),
      kind_(kind),
      turns_(binding(place.restrictions, kind)),
      ways_(binding(place.way_restrictions, kind)) {}

int JunctionRoutes::first_node(int state) const {
  const InnerEdge& edge = place_.inner[state / 2];
  return state % 2 == 0 ? edge.from_node : edge.to_node;
}

bool JunctionRoutes::open(int state) const {
  const InnerEdge& edge = place_.inner[state / 2];
  const LaneKinds& lanes = state % 2 == 0 ? edge.along : edge.against;
  return kind_ ? lanes[index_of(LaneKind::general)] || lanes[index_of(*kind_)] : lanes.any();
}

JunctionRoutes::Arm JunctionRoutes::arm_of(int state, bool at_start) const {
  const InnerEdge& edge = place_.inner[state / 2];
  const Line& line = edge.line;
  const std::size_t last = line.size() - 1;
  if (state % 2 == 0)
    return {edge.axis_id, edge.edge,
            at_start ? heading(line[0], line[1]) : heading(line[last - 1], line[last])};
  return {edge.axis_id, edge.edge,
          at_start ? heading(line[last], line[last - 1]) : heading(line[1], line[0])};
}

JunctionRoutes::Arm JunctionRoutes::arm_of_leg(int leg, bool comes_in) const {
  Arm arm{place_.legs[leg].axis_id, place_.legs[leg].edge, {}};
  for (const JunctionLane& lane : place_.lanes) {
    if (lane.leg != leg || lane.comes_in != comes_in) continue;
    const std::size_t last = lane.line.size() - 1;
    arm.heading = comes_in ? heading(lane.line[last - 1], lane.line[last])
                           : heading(lane.line[0], lane.line[1]);
    break;
  }
  return arm;
}

// The number of ends of edges inside and of legs.
int JunctionRoutes::ends_at(int node, std::int64_t axis_id) const {
  int ends = 0;
  for (const InnerEdge& edge : place_.inner)
    if (edge.axis_id == axis_id) ends += (edge.from_node == node) + (edge.to_node == node);
  for (const JunctionLeg& leg : place_.legs) ends += leg.axis_id == axis_id && leg.node == node;
  return ends;
}

bool JunctionRoutes::touches(int node, int edge) const {
  return std::any_of(place_.inner.begin(), place_.inner.end(), [&](const InnerEdge& inner) {
    return inner.edge == edge && (inner.from_node == node || inner.to_node == node);
  });
}

bool JunctionRoutes::turn_allowed(int node, const Arm& from, const Arm& to) const {
  bool only = false, named = false;
  for (const TurnRestriction& r : turns_) {
    if (r.from_axis != from.axis_id || distance(r.via, place_.nodes[node]) > 3 * node_tolerance_)
      continue;
    // Its turn tells the edges of an axis that goes on beyond the node apart.
    const bool named_here = r.to_axis == to.axis_id &&
                            (!r.turn || *r.turn == turn_of(turn_angle(from.heading, to.heading)) ||
                             (ends_at(node, r.from_axis) == 1 && ends_at(node, r.to_axis) == 1));
    if (!r.only && named_here) return false;
    only = only || r.only;
    named = named || (r.only && named_here);
  }
  return !only || named;
}

bool JunctionRoutes::way_allowed(const WayRestriction& r, int followed, int node,
                                 const Arm& to) const {
  const int passed = static_cast<int>(r.via.size()) + 1;
  if (!r.only) return followed < passed || to.axis_id != r.to_axis;
  if (followed == 0) return true;
  if (followed < passed) {
    const int next = r.via[followed - 1];
    return to.edge == next || !touches(node, next);
  }
  return to.axis_id == r.to_axis || ends_at(node, r.to_axis) == 0;
}

bool JunctionRoutes::allowed(int node, const Arm& from, const Arm& to,
                             const Followed& followed) const {
  for (std::size_t r = 0; r < ways_.size(); ++r)
    if (!way_allowed(ways_[r], followed[r], node, to)) return false;
  return turns_.empty() || turn_allowed(node, from, to);
}

JunctionRoutes::Followed JunctionRoutes::follow(Followed followed, const Arm& arm) const {
  for (std::size_t r = 0; r < ways_.size(); ++r) {
    const WayRestriction& way = ways_[r];
    int& at = followed[r];
    if (at > 0 && at <= static_cast<int>(way.via.size()) && arm.edge == way.via[at - 1])
      ++at;
    else if (at == 0 && arm.axis_id == way.from_axis)
      at = 1;
  }
  return followed;
}

std::vector<std::optional<JunctionRoute>> JunctionRoutes::from(int leg) const {
  struct Visit {
    int state, before;
    Followed followed;
    double cost;
  };
  std::vector<std::optional<JunctionRoute>> routes(place_.legs.size());
  const Arm start = arm_of_leg(leg, true);
  const Followed begun = follow(Followed(ways_.size()), start);
  const int states = 2 * static_cast<int>(place_.inner.size());
  std::vector<Visit> visits;
  std::map<std::pair<int, Followed>, int> known;
  using Entry = std::pair<double, int>;  // cost, and index into visits
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto go_on = [&](int node, const Arm& at, const Followed& followed, int before,
                         double spent) {
    for (int s = 0; s < states; ++s) {
      if (!open(s) || first_node(s) != node ||
          (before != none && s / 2 == visits[before].state / 2))
        continue;
      const Arm next = arm_of(s, true);
      if (!allowed(node, at, next, followed)) continue;
      const Followed grown = follow(followed, next);
      const double cost = spent + length(place_.inner[s / 2].line);
      const auto [found, fresh] = known.emplace(std::make_pair(s, grown), none);
      if (!fresh && visits[found->second].cost <= cost) continue;
      found->second = static_cast<int>(visits.size());
      visits.push_back({s, before, grown, cost});
      queue.push({cost, found->second});
    }
  };
  const auto reach = [&](int node, const Arm& at, const Followed& followed, int visit) {
    for (std::size_t to = 0; to < place_.legs.size(); ++to) {
      if (routes[to] || place_.legs[to].node != node ||
          !allowed(node, at, arm_of_leg(static_cast<int>(to), false), followed))
        continue;
      routes[to].emplace();
      for (int v = visit; v != none; v = visits[v].before)
        routes[to]->push_back(piece_of(visits[v].state));
      std::reverse(routes[to]->begin(), routes[to]->end());
    }
  };
  reach(place_.legs[leg].node, start, begun, none);
  go_on(place_.legs[leg].node, start, begun, none, 0);
  while (!queue.empty()) {
    const auto [cost, index] = queue.top();
    queue.pop();
    const Visit visit = visits[index];
    if (visit.cost < cost || known.at({visit.state, visit.followed}) != index) continue;
    const Arm at = arm_of(visit.state, false);
    reach(last_node(visit.state), at, visit.followed, index);
    go_on(last_node(visit.state), at, visit.followed, index, cost);
  }
  return routes;
}

}  // namespace streetgen
