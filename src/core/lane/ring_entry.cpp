#include "lane/ring_entry.hpp"

#include <algorithm>

#include "geometry/polyline.hpp"

namespace streetgen {

namespace {

// Metres.
constexpr double beside_ring = 0.5;  // from the roadway of the ring to the middle of the line
constexpr double moved = 0.25;       // away from the node, each time that it lies on the ring

}  // namespace

RingEntries::RingEntries(const Streets& streets, const LaneWishes& wishes)
    : streets_(streets), rings_(streets.network.nodes.size()) {
  const std::vector<Edge>& edges = streets.network.edges;
  for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
    on_ring_.push_back(wishes.on_ring(edges[e]));
    if (!on_ring_.back()) continue;
    rings_[edges[e].from_node].push_back(e);
    rings_[edges[e].to_node].push_back(e);
  }
}

int RingEntries::node_of(int edge, bool at_start) const {
  const Edge& found = streets_.network.edges[edge];
  return at_start ? found.from_node : found.to_node;
}

bool RingEntries::enters(int edge, bool at_start) const {
  return !on_ring_[edge] && !rings_[node_of(edge, at_start)].empty();
}

bool RingEntries::on_roadway(const Point& place, int node) const {
  const std::vector<int>& rings = rings_[node];
  return std::any_of(rings.begin(), rings.end(), [&](int ring) {
    const Roadway& roadway = streets_.roadways[ring];
    return comes_within(place, streets_.network.edges[ring].line,
                        std::max(roadway.width, roadway.width_end) / 2 +
                            std::abs(roadway.roadway_offset) + beside_ring);
  });
}

std::optional<RingEntries::Place> RingEntries::before_ring(const LaneStrip& strip, const Lane& lane,
                                                           bool at_start,
                                                           bool limits_crossed) const {
  const double total = length(strip.axis), limit = at_start ? strip.from : strip.to;
  const auto leftwards = [&](double abscissa) {
    return left_normal(local_direction(strip.axis, abscissa));
  };
  const Point end = at_start ? lane.line.front() : lane.line.back();
  const double offset = dot(end - position_at(strip.axis, limit).point, leftwards(limit));
  const double farthest = limits_crossed ? total : at_start ? limit : total - limit;
  for (double away = 0; away <= farthest; away += moved) {
    const double abscissa = at_start ? away : total - away;
    const Point left = leftwards(abscissa);
    const Point middle = planar(position_at(strip.axis, abscissa).point) + left * offset;
    const Point half = left * (lane.width / 2);
    const int node = node_of(lane.edge, at_start);
    if (on_roadway(middle - half, node) || on_roadway(middle, node) ||
        on_roadway(middle + half, node))
      continue;
    return Place{middle, left * -1};
  }
  return std::nullopt;
}

}  // namespace streetgen
