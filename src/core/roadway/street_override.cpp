#include "roadway/street_override.hpp"

#include <algorithm>

#include "geometry/box_index.hpp"
#include "geometry/polyline.hpp"
#include "layout/node_corner.hpp"

namespace streetgen {

namespace {

// Metres; nearer to a node a place lies on none of its sides.
constexpr double on_node = 1e-3;

// The edge that holds the abscissa: of two that meet there, the one whose limit it can be.
const Edge* edge_of(const Network& network, const SectionLimitOverride& put) {
  const auto place = std::pair(put.axis_id, put.abscissa);
  const auto starts = [](const Edge& edge) { return std::pair(edge.axis_id, edge.start_abscissa); };
  const auto& edges = network.edges;
  const auto after =
      put.at_start
          ? std::upper_bound(edges.begin(), edges.end(), place,
                             [&](const auto& p, const Edge& edge) { return p < starts(edge); })
          : std::lower_bound(edges.begin(), edges.end(), place,
                             [&](const Edge& edge, const auto& p) { return starts(edge) < p; });
  if (after == edges.begin()) return nullptr;
  const Edge& edge = *(after - 1);
  const bool beyond =
      put.at_start ? put.abscissa >= edge.end_abscissa : put.abscissa > edge.end_abscissa;
  return edge.axis_id != put.axis_id || beyond ? nullptr : &edge;
}

}  // namespace

double least_limit(const Arm& arm) { return std::min(0.1, length(arm.line) / 4); }

LimitsByHand limits_by_hand(const Layout& layout, const std::vector<SectionLimitOverride>& puts) {
  LimitsByHand limits(layout.arms.size());
  const auto& edges = layout.streets.network.edges;
  const auto dead_end = [&](int node) { return layout.junctions[node].dead_end(); };
  const auto least = [&](int node, const Arm& arm) {
    return dead_end(node) ? 0 : least_limit(arm);
  };
  for (const SectionLimitOverride& put : puts) {
    const Edge* edge = edge_of(layout.streets.network, put);
    if (edge == nullptr || dead_end(put.at_start ? edge->from_node : edge->to_node)) continue;
    const int e = static_cast<int>(edge - edges.data());
    const Arm& along = layout.arms[2 * e];
    const double total = length(along.line);
    const double share =
        (put.abscissa - edge->start_abscissa) / (edge->end_abscissa - edge->start_abscissa);
    // On an edge too short for both, the room at its end goes first.
    const double abscissa = std::min(std::max(share * total, least(edge->from_node, along)),
                                     total - least(edge->to_node, along));
    limits[slot({e, put.at_start})] = put.at_start ? abscissa : total - abscissa;
  }
  return limits;
}

RadiiByHand radii_by_hand(const Layout& layout, const std::vector<CornerOverride>& wanted) {
  RadiiByHand radii;
  if (wanted.empty()) return radii;
  std::vector<Box> places;
  for (const Node& node : layout.streets.network.nodes)
    places.push_back(box_of(node.point, node.point));
  const BoxIndex nodes(places);
  const auto corners_of = [&](const Junction& junction, const CornerOverride& put) {
    std::vector<std::size_t> corners;
    for (std::size_t i = 0; i < junction.ends.size() && !junction.dead_end(); ++i)
      if (layout.axis_of(junction.ends[i].edge).axis_id == put.axis_a &&
          layout.axis_of(junction.next(i).edge).axis_id == put.axis_b)
        corners.push_back(i);
    return corners;
  };
  for (const CornerOverride& put : wanted) {
    int nearest = -1;
    double least = 3 * layout.settings.tolerance;
    std::vector<std::size_t> meant;
    for (const int n : nodes.near(box_of(put.place, put.place), least)) {
      const double away = distance(layout.streets.network.nodes[n].point, put.place);
      if (away > least || (away == least && nearest >= 0)) continue;
      std::vector<std::size_t> corners = corners_of(layout.junctions[n], put);
      if (corners.empty()) continue;
      nearest = n;
      least = away;
      meant = std::move(corners);
    }
    for (const std::size_t i : meant) {
      const Junction& junction = layout.junctions[nearest];
      const Arm &a = layout.arm(junction.ends[i]), &b = layout.arm(junction.next(i));
      const Arm towards{{planar(a.line.front()), planar(put.place)}, 0, 0, 0, {}};
      if (meant.size() > 1 && least > on_node && angle_between(a, towards) > angle_between(a, b))
        continue;
      radii[{nearest, i}] = put.radius;
    }
  }
  return radii;
}

}  // namespace streetgen
