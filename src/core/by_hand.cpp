#include "by_hand.hpp"

#include <algorithm>

#include "around.hpp"
#include "box_index.hpp"
#include "polyline.hpp"

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

std::vector<std::optional<double>> limits_by_hand(const Network& network,
                                                  const std::vector<Arm>& arms,
                                                  const EndsOfNode& ends_of,
                                                  const std::vector<SectionLimitOverride>& puts) {
  std::vector<std::optional<double>> limits(arms.size());
  const auto least = [&](int node, const Arm& arm) {
    return ends_of(node).size() > 1 ? least_limit(arm) : 0;
  };
  for (const SectionLimitOverride& put : puts) {
    const Edge* edge = edge_of(network, put);
    if (edge == nullptr) continue;
    if (ends_of(put.at_start ? edge->from_node : edge->to_node).size() < 2) continue;
    const int e = static_cast<int>(edge - network.edges.data());
    const Arm& along = arms[2 * e];
    const double total = length(along.line);
    const double share =
        (put.abscissa - edge->start_abscissa) / (edge->end_abscissa - edge->start_abscissa);
    const double abscissa = std::clamp(share * total, least(edge->from_node, along),
                                       total - least(edge->to_node, along));
    limits[slot({e, put.at_start})] = put.at_start ? abscissa : total - abscissa;
  }
  return limits;
}

RadiiByHand radii_by_hand(const Network& network, const std::vector<Arm>& arms,
                          const EndsOfNode& ends_of, const std::vector<CornerOverride>& wanted,
                          double tolerance) {
  RadiiByHand radii;
  if (wanted.empty()) return radii;
  std::vector<Box> places;
  for (const Node& node : network.nodes) places.push_back(box_of(node.point, node.point));
  const BoxIndex nodes(places);
  const auto next = [&](int node, std::size_t i) {
    return ends_of(node)[(i + 1) % ends_of(node).size()];
  };
  const auto corners_of = [&](int node, const CornerOverride& put) {
    const auto axis_of = [&](const EdgeEnd& end) { return network.edges[end.edge].axis_id; };
    std::vector<std::size_t> corners;
    const std::vector<EdgeEnd>& ends = ends_of(node);
    for (std::size_t i = 0; i < ends.size() && ends.size() > 1; ++i)
      if (axis_of(ends[i]) == put.axis_a && axis_of(next(node, i)) == put.axis_b)
        corners.push_back(i);
    return corners;
  };
  for (const CornerOverride& put : wanted) {
    int nearest = -1;
    double least = 3 * tolerance;
    std::vector<std::size_t> meant;
    for (const int n : nodes.near(box_of(put.place, put.place), least)) {
      const double away = distance(network.nodes[n].point, put.place);
      if (away > least || (away == least && nearest >= 0)) continue;
      std::vector<std::size_t> corners = corners_of(n, put);
      if (corners.empty()) continue;
      nearest = n;
      least = away;
      meant = std::move(corners);
    }
    for (const std::size_t i : meant) {
      const Arm &a = arms[slot(ends_of(nearest)[i])], &b = arms[slot(next(nearest, i))];
      const Arm towards{{planar(a.line.front()), planar(put.place)}, 0, 0, 0, {}};
      if (meant.size() > 1 && least > on_node && angle_between(a, towards) > angle_between(a, b))
        continue;
      radii[{nearest, i}] = put.radius;
    }
  }
  return radii;
}

}  // namespace streetgen
