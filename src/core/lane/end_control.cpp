#include "lane/end_control.hpp"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "geometry/polyline.hpp"

namespace streetgen {

namespace {

constexpr double on_node = 1.5;  // metres from a node within which a point lies on the node
constexpr std::size_t junction_degree = 3;

class Controls {
 public:
  Controls(const Network& network, const std::vector<LanesOfAxis>& lanes, double farthest)
      : edges_(network.edges),
        farthest_(farthest),
        slots_(network.nodes.size()),
        ends_(2 * edges_.size()) {
    for (const LanesOfAxis& axis : lanes) lanes_.emplace(axis.axis_id, &axis.lanes);
    for (int e = 0; e < static_cast<int>(edges_.size()); ++e) {
      of_axis_[edges_[e].axis_id].push_back(e);
      slots_[edges_[e].from_node].push_back(2 * e);
      slots_[edges_[e].to_node].push_back(2 * e + 1);
    }
  }

  void put(const ControlPoint& point) {
    const auto found = of_axis_.find(point.axis_id);
    if (found == of_axis_.end()) return;
    for (const int e : found->second) {
      const Edge& edge = edges_[e];
      if (point.abscissa < edge.start_abscissa - on_node ||
          point.abscissa > edge.end_abscissa + on_node)
        continue;
      put_on_edge(point, e, point.abscissa - edge.start_abscissa,
                  edge.end_abscissa - point.abscissa);
    }
  }

  void decide(const JunctionDecision& decision, const std::vector<Node>& nodes) {
    const auto found = of_axis_.find(decision.axis_id);
    if (found == of_axis_.end()) return;
    const auto off = [&](int slot) {
      return distance(planar(nodes[node_of(slot)].point), decision.place);
    };
    int nearest = 2 * found->second.front();
    for (const int e : found->second)
      for (const int slot : {2 * e, 2 * e + 1})
        if (off(slot) < off(nearest)) nearest = slot;
    if (off(nearest) > farthest_) return;
    for (const int slot : slots_[node_of(nearest)]) ends_[slot].decided = decision.kind;
  }

  std::vector<EndControl> run() {
    for (const std::vector<int>& slots : slots_) {
      std::optional<ControlKind> highest;
      for (const int slot : slots)
        if (ends_[slot].own && (!highest || *ends_[slot].own < *highest)) highest = ends_[slot].own;
      for (const int slot : slots) ends_[slot].at_node = highest;
    }
    return std::move(ends_);
  }

 private:
  using Direction = ControlPoint::Direction;

  int node_of(int slot) const {
    const Edge& edge = edges_[slot / 2];
    return slot % 2 == 0 ? edge.from_node : edge.to_node;
  }

  bool is_junction(int node) const { return slots_[node].size() >= junction_degree; }

  void put_on_edge(const ControlPoint& point, int e, double to_start, double to_end) {
    if (to_start <= on_node || to_end <= on_node) {
      const int slot = 2 * e + (to_end < to_start ? 1 : 0);
      put_on_node(point, slot);
      return;
    }
    const Direction direction = direction_of(point, e, to_start, to_end);
    if (direction != Direction::against) put_at(2 * e + 1, point.kind, to_end);
    if (direction != Direction::along) put_at(2 * e, point.kind, to_start);
  }

  // By the edge that its direction leads over to the node; without a direction by all.
  void put_on_node(const ControlPoint& point, int slot) {
    const bool at_end = slot % 2 == 1;
    const bool comes_by = point.direction == (at_end ? Direction::along : Direction::against);
    const bool leaves_by = point.direction == (at_end ? Direction::against : Direction::along);
    if (comes_by) put_at(slot, point.kind, 0);
    if (comes_by || leaves_by) return;
    for (const int other : slots_[node_of(slot)]) put_at(other, point.kind, 0);
  }

  Direction direction_of(const ControlPoint& point, int e, double to_start, double to_end) const {
    if (point.direction != Direction::unknown) return point.direction;
    const auto found = lanes_.find(point.axis_id);
    if (found != lanes_.end() && found->second->both_ways.empty()) {
      if (found->second->backward.empty()) return Direction::along;
      if (found->second->forward.empty()) return Direction::against;
    }
    const bool junction_at_start = is_junction(edges_[e].from_node);
    const bool junction_at_end = is_junction(edges_[e].to_node);
    if (junction_at_start != junction_at_end)
      return junction_at_end ? Direction::along : Direction::against;
    return to_end <= to_start ? Direction::along : Direction::against;
  }

  void put_at(int slot, ControlKind kind, double before) {
    if (before > farthest_ || (before > 0 && !is_junction(node_of(slot)))) return;
    std::optional<ControlKind>& own = ends_[slot].own;
    if (!own || kind < *own) own = kind;
  }

  const std::vector<Edge>& edges_;
  double farthest_;
  std::vector<std::vector<int>> slots_;  // by node
  std::unordered_map<std::int64_t, const AxisLanes*> lanes_;
  std::unordered_map<std::int64_t, std::vector<int>> of_axis_;
  std::vector<EndControl> ends_;
};

}  // namespace

const char* control_kind_name(ControlKind kind) noexcept {
  switch (kind) {
    case ControlKind::signals:
      return "signals";
    case ControlKind::stop:
      return "stop";
    case ControlKind::yield:
      return "yield";
    case ControlKind::mini_roundabout:
      return "mini_roundabout";
    case ControlKind::pedestrian_crossing:
      return "pedestrian_crossing";
  }
  return "";
}

std::vector<EndControl> end_controls(const Network& network, const std::vector<LanesOfAxis>& lanes,
                                     const std::vector<ControlPoint>& points, double farthest,
                                     const std::vector<JunctionDecision>& decisions) {
  if (points.empty() && decisions.empty()) return std::vector<EndControl>(2 * network.edges.size());
  Controls controls(network, lanes, farthest);
  for (const ControlPoint& point : points) controls.put(point);
  for (const JunctionDecision& decision : decisions) controls.decide(decision, network.nodes);
  return controls.run();
}

std::vector<ControlPoint> with_ring_entries(const Network& network,
                                            const std::vector<LanesOfAxis>& lanes,
                                            std::vector<ControlPoint> points) {
  std::unordered_set<std::int64_t> rings;
  for (const LanesOfAxis& axis : lanes)
    if (axis.on_ring) rings.insert(axis.axis_id);
  if (rings.empty()) return points;
  std::vector<bool> on_ring(network.nodes.size());
  for (const Edge& edge : network.edges)
    if (rings.count(edge.axis_id) > 0) on_ring[edge.from_node] = on_ring[edge.to_node] = true;
  for (const Edge& edge : network.edges) {
    if (rings.count(edge.axis_id) > 0) continue;
    const auto yields = [&](double abscissa, ControlPoint::Direction direction) {
      points.push_back({edge.axis_id, abscissa, ControlKind::yield, direction});
    };
    if (on_ring[edge.from_node]) yields(edge.start_abscissa, ControlPoint::Direction::against);
    if (on_ring[edge.to_node]) yields(edge.end_abscissa, ControlPoint::Direction::along);
  }
  return points;
}

}  // namespace streetgen
