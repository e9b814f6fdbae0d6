#include "network/cut_at_signals.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <unordered_set>
#include <utility>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
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

// A vertex nearer than that to a place along the line takes the cut: ends so near to a vertex are
// one place of the network.
constexpr double vertex_reach = 0.5;  // metres

double at_vertex(const Line& line, double at) {
  double metres = 0, nearest = at, off = vertex_reach;
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    metres += distance(line[i - 1], line[i]);
    if (std::abs(metres - at) >= off) continue;
    off = std::abs(metres - at);
    nearest = metres;
  }
  return nearest;
}

// The piece of an edge from its start to a cut; the edge is what is left.
Edge cut_off(Edge& edge, double place, int node, Network& network) {
  const double total = length(edge.line), metres = edge.end_abscissa - edge.start_abscissa;
  const double wanted = total * (place - edge.start_abscissa) / metres,
               at = at_vertex(edge.line, wanted),
               abscissa = at == wanted ? place : edge.start_abscissa + at / total * metres;
  Edge first = edge;
  first.line = substring(edge.line, 0, at);
  first.end_abscissa = edge.start_abscissa = abscissa;
  first.to_node = edge.from_node = node;
  edge.line = substring(edge.line, at, total);
  // A cut at a vertex of the axis gives it to both, once.
  Line& before = first.line;
  if (before.size() > 2 && distance(before.back(), before[before.size() - 2]) < same_place)
    before.pop_back();
  if (edge.line.size() > 2 && distance(edge.line[0], edge.line[1]) < same_place)
    edge.line.erase(edge.line.begin());
  edge.line.front() = before.back();
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
