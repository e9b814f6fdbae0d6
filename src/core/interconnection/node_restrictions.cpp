#include "interconnection/node_restrictions.hpp"

#include <algorithm>
#include <unordered_map>

#include "geometry/polyline.hpp"
#include "interconnection/movement_angle.hpp"
#include "interconnection/turn.hpp"

namespace streetgen {

namespace {

// Whether a restriction speaks of the movement, whatever it says of it.
bool concerns(const TurnRestriction& r, const std::vector<std::int64_t>& axes,
              const Movement& movement, Turn turn) {
  if (axes[movement.from] != r.from_axis || axes[movement.to] != r.to_axis) return false;
  const bool certain = std::count(axes.begin(), axes.end(), r.from_axis) == 1 &&
                       std::count(axes.begin(), axes.end(), r.to_axis) == 1;
  return certain || !r.turn || *r.turn == turn;
}

}  // namespace

NodeRestrictions::NodeRestrictions(const Network& network,
                                   const std::vector<TurnRestriction>& restrictions,
                                   double tolerance) {
  std::unordered_map<std::int64_t, std::vector<int>> nodes_of;
  for (const TurnRestriction& r : restrictions) {
    nodes_of[r.from_axis];
    nodes_of[r.to_axis];
  }
  for (const Edge& edge : network.edges) {
    const auto found = nodes_of.find(edge.axis_id);
    if (found == nodes_of.end()) continue;
    for (const int node : {edge.from_node, edge.to_node})
      if (std::find(found->second.begin(), found->second.end(), node) == found->second.end())
        found->second.push_back(node);
  }
  for (const TurnRestriction& r : restrictions) {
    const std::vector<int>&from = nodes_of[r.from_axis], &to = nodes_of[r.to_axis];
    int best = -1;
    double least = 3 * tolerance;
    for (const int node : from) {
      const double away = distance(network.nodes[node].point, r.via);
      if (away > least || (away == least && best >= 0) ||
          std::find(to.begin(), to.end(), node) == to.end())
        continue;
      best = node;
      least = away;
    }
    if (best >= 0) of_node_[best].push_back(&r);
  }
}

void NodeRestrictions::mark(int node, const std::vector<std::int64_t>& axes,
                            const std::vector<Leg>& legs, std::vector<Movement>& movements) const {
  const auto found = of_node_.find(node);
  if (found == of_node_.end()) return;
  std::vector<LaneKinds> only(legs.size()), allowed(movements.size());
  for (const TurnRestriction* r : found->second) {
    LaneKinds bound = LaneKinds().set();
    for (const LaneKind kind : r->except) bound.reset(index_of(kind));
    for (std::size_t m = 0; m < movements.size(); ++m) {
      Movement& movement = movements[m];
      const double angle = movement_angle(legs[movement.from], legs[movement.to]);
      const Turn turn = turn_called(movement.turns_back, angle, angle);
      if (!concerns(*r, axes, movement, turn)) continue;
      if (r->only) {
        only[movement.from] |= bound;
        allowed[m] |= bound;
      } else {
        movement.restricted |= bound;
      }
    }
  }
  for (std::size_t m = 0; m < movements.size(); ++m)
    movements[m].restricted |= only[movements[m].from] & ~allowed[m];
}

}  // namespace streetgen
