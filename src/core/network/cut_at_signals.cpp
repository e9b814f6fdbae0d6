#include "network/cut_at_signals.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <unordered_set>
#include <utility>

#include "geometry/polyline.hpp"
#include "network/control_reach.hpp"

namespace streetgen {

namespace {

std::vector<ControlPoint> points_of(const std::vector<const StreetAxis*>& axes) {
  std::vector<ControlPoint> points;
  std::unordered_set<std::int64_t> seen;
  for (const StreetAxis* axis : axes)
    if (!axis->on_ring && seen.insert(axis->axis_id).second)
      points.insert(points.end(), axis->controls.begin(), axis->controls.end());
  return points;
}

// By edge, the places where it is cut.
std::map<int, std::vector<double>> cuts_of(const Network& network,
                                           const std::vector<const StreetAxis*>& axes,
                                           const ControlRules& rules) {
  std::map<int, std::vector<double>> cuts;
  const std::vector<ControlPoint> points = points_of(axes);
  if (points.empty()) return cuts;
  std::vector<EdgeWays> ways;
  for (const StreetAxis* axis : axes)
    ways.push_back({axis->leads_forward, axis->leads_backward, axis->on_ring});
  const ControlReach reach(network, std::move(ways), points, rules);
  for (const MidBlockSignals& place : reach.mid_block_signals(points))
    for (const int e : reach.edges_of(place.axis_id))
      if (place.abscissa > network.edges[e].start_abscissa + on_node &&
          place.abscissa < network.edges[e].end_abscissa - on_node)
        cuts[e].push_back(place.abscissa);
  return cuts;
}

// The piece of an edge from its start to a cut; the edge is what is left.
Edge cut_off(Edge& edge, double abscissa, int node, Network& network) {
  const double total = length(edge.line);
  const double at =
      total * (abscissa - edge.start_abscissa) / (edge.end_abscissa - edge.start_abscissa);
  Edge first = edge;
  first.line = substring(edge.line, 0, at);
  first.end_abscissa = edge.start_abscissa = abscissa;
  first.to_node = edge.from_node = node;
  edge.line = substring(edge.line, at, total);
  edge.line.front() = first.line.back();
  network.nodes.push_back({first.line.back(), {{edge.axis_id, abscissa}}});
  return first;
}

// Nodes are numbered by their smallest anchor.
void number_nodes(Network& network) {
  const auto anchor = [](const Node& node) {
    return std::tie(node.anchors.front().axis_id, node.anchors.front().abscissa);
  };
  std::vector<int> order(network.nodes.size()), number(network.nodes.size());
  for (std::size_t n = 0; n < order.size(); ++n) order[n] = static_cast<int>(n);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return anchor(network.nodes[a]) < anchor(network.nodes[b]);
  });
  std::vector<Node> nodes;
  for (const int n : order) {
    number[n] = static_cast<int>(nodes.size());
    nodes.push_back(std::move(network.nodes[n]));
  }
  network.nodes = std::move(nodes);
  for (Edge& edge : network.edges) {
    edge.from_node = number[edge.from_node];
    edge.to_node = number[edge.to_node];
  }
}

}  // namespace

void cut_at_signals(Network& network, std::vector<const StreetAxis*>& axes,
                    const ControlRules& rules) {
  std::map<int, std::vector<double>> cuts = cuts_of(network, axes, rules);
  if (cuts.empty()) return;
  std::vector<Edge> edges;
  std::vector<const StreetAxis*> of_edges;
  for (int e = 0; e < static_cast<int>(axes.size()); ++e) {
    Edge& edge = network.edges[e];
    std::vector<double>& places = cuts[e];
    std::sort(places.begin(), places.end());
    for (const double abscissa : places) {
      edges.push_back(cut_off(edge, abscissa, static_cast<int>(network.nodes.size()), network));
      of_edges.push_back(axes[e]);
    }
    edges.push_back(std::move(edge));
    of_edges.push_back(axes[e]);
  }
  network.edges = std::move(edges);
  axes = std::move(of_edges);
  number_nodes(network);
}

}  // namespace streetgen
