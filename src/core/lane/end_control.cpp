#include "lane/end_control.hpp"

#include <algorithm>
#include <unordered_set>

#include "geometry/polyline.hpp"
#include "lane/right_of_way.hpp"

namespace streetgen {

namespace {

constexpr double heading_reach = 10;  // metres, over which an edge's end has its direction
constexpr int important = 3;          // streets of this importance and better have priority

class Controls {
 public:
  Controls(const Network& network, const std::vector<ControlEdge>& edges,
           const std::vector<ControlPoint>& points, const ControlRules& rules)
      : network_(network),
        edges_(edges),
        rules_(rules),
        reach_(network, ways_of(edges), points, rules),
        out_{std::vector<EndControl>(2 * edges.size()), {}} {}

  void put(const std::vector<ControlPoint>& points) {
    out_.served.assign(points.size(), -1);
    for (const MidBlockSignals& place : reach_.mid_block_signals(points)) {
      const int node = node_at(place);
      if (node < 0) continue;
      for (const int point : place.points)
        for (const int slot : reach_.slots_at(node))
          put_at(slot, ControlKind::signals, out_.served[point]);
    }
    for (std::size_t p = 0; p < points.size(); ++p) {
      if (out_.served[p] >= 0) continue;
      const ControlledEnds found = reach_.ends_of(points[p]);
      for (const int slot : found.slots)
        if (speaks_to(points[p], slot, found)) put_at(slot, points[p].kind, out_.served[p]);
    }
  }

  void decide(const JunctionDecision& decision) {
    const std::vector<int>& found = reach_.edges_of(decision.axis_id);
    if (found.empty()) return;
    const auto off = [&](int slot) {
      return distance(planar(network_.nodes[reach_.node_of(slot)].point), decision.place);
    };
    int nearest = 2 * found.front();
    for (const int e : found)
      for (const int slot : {2 * e, 2 * e + 1})
        if (off(slot) < off(nearest)) nearest = slot;
    if (off(nearest) > rules_.farthest) return;
    for (const int slot : reach_.slots_at(reach_.node_of(nearest)))
      out_.ends[slot].decided = decision.kind;
  }

  EndControls run() {
    for (int node = 0; node < static_cast<int>(network_.nodes.size()); ++node) settle(node);
    for (int slot = 0; slot < static_cast<int>(out_.ends.size()); ++slot)
      out_.ends[slot].within = out_.ends[slot].at_signals() && comes_from_signals(slot);
    return std::move(out_);
  }

 private:
  static std::vector<EdgeWays> ways_of(const std::vector<ControlEdge>& edges) {
    std::vector<EdgeWays> ways;
    for (const ControlEdge& edge : edges) ways.push_back(edge.ways);
    return ways;
  }

  void put_at(int slot, ControlKind kind, int& served) {
    std::optional<ControlKind>& own = out_.ends[slot].own;
    if (!own || kind < *own) own = kind;
    if (served < 0) served = reach_.node_of(slot);
  }

  // A sign at the very junction speaks to those who wait there.
  bool speaks_to(const ControlPoint& point, int slot, const ControlledEnds& found) const {
    const bool sign = point.kind == ControlKind::stop || point.kind == ControlKind::yield;
    if (!sign || !found.junction || point.direction == ControlPoint::Direction::both) return true;
    return waits_at(*found.junction, slot);
  }

  bool waits_at(int node, int slot) const {
    const std::vector<int>& slots = reach_.slots_at(node);
    const std::vector<bool> waits = arms_that_wait(arms_at(node));
    return waits[std::find(slots.begin(), slots.end(), slot) - slots.begin()];
  }

  std::vector<RankedArm> arms_at(int node) const {
    std::vector<RankedArm> arms;
    for (const int slot : reach_.slots_at(node)) {
      const ControlEdge& edge = edges_[slot / 2];
      const bool at_start = slot % 2 == 0;
      arms.push_back({at_start ? edge.from_start : edge.from_end, edge.importance,
                      at_start ? edge.width : edge.width_end, network_.edges[slot / 2].axis_id,
                      at_start ? edge.ways.against : edge.ways.along,
                      at_start ? edge.ways.along : edge.ways.against});
    }
    return arms;
  }

  // The node of two edges on which signals in mid-block stand.
  int node_at(const MidBlockSignals& place) const {
    for (const int e : reach_.edges_of(place.axis_id))
      for (const int slot : {2 * e, 2 * e + 1}) {
        const double abscissa =
            slot % 2 == 0 ? network_.edges[e].start_abscissa : network_.edges[e].end_abscissa;
        if (std::abs(place.abscissa - abscissa) <= on_node &&
            reach_.slots_at(reach_.node_of(slot)).size() == 2)
          return reach_.node_of(slot);
      }
    return -1;
  }

  void settle(int node) {
    const std::vector<int>& slots = reach_.slots_at(node);
    std::optional<ControlKind> highest;
    for (const int slot : slots) {
      const std::optional<ControlKind>& own = out_.ends[slot].own;
      if (own && (!highest || *own < *highest)) highest = own;
    }
    int best = 99;
    for (const int slot : slots) {
      out_.ends[slot].at_node = highest;
      best = std::min(best, edges_[slot / 2].importance);
    }
    if (!reach_.is_junction(node)) return;
    const std::vector<RankedArm> arms = arms_at(node);
    const auto leaving = [](const RankedArm& arm) { return arm.leaves; };
    const bool merge = std::count_if(arms.begin(), arms.end(), leaving) == 1;
    if (best > important && !merge) return;
    const std::vector<bool> waits = arms_that_wait(arms);
    for (std::size_t i = 0; i < slots.size(); ++i)
      out_.ends[slots[i]].waits = waits[i] && edges_[slots[i] / 2].importance == best;
  }

  // Over nodes of two edges, back to other signals.
  bool comes_from_signals(int slot) const {
    const auto length = [&](int e) {
      return network_.edges[e].end_abscissa - network_.edges[e].start_abscissa;
    };
    double metres = length(slot / 2);
    int back = slot ^ 1;
    while (metres <= rules_.queue) {
      if (out_.ends[back].at_signals()) return true;
      const std::vector<int>& slots = reach_.slots_at(reach_.node_of(back));
      if (slots.size() != 2) return false;
      const int next = slots[0] == back ? slots[1] : slots[0];
      if (next / 2 == slot / 2) return false;
      metres += length(next / 2);
      back = next ^ 1;
    }
    return false;
  }

  const Network& network_;
  const std::vector<ControlEdge>& edges_;
  const ControlRules& rules_;
  ControlReach reach_;
  EndControls out_;
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

ControlEdge control_edge(const EdgeWays& ways, int importance, double width, double width_end,
                         const Line& line) {
  const auto leaves = [](const Line& from) {
    const double reach = std::min(heading_reach, length(from));
    return unit(planar(position_at(from, reach).point) - planar(from.front()));
  };
  return {ways, importance, width, width_end, leaves(line), leaves(reversed(line))};
}

EndControls end_controls(const Network& network, const std::vector<ControlEdge>& edges,
                         const std::vector<ControlPoint>& points, const ControlRules& rules,
                         const std::vector<JunctionDecision>& decisions) {
  Controls controls(network, edges, points, rules);
  controls.put(points);
  for (const JunctionDecision& decision : decisions) controls.decide(decision);
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
