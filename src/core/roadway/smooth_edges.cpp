#include "roadway/smooth_edges.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "geometry/polyline.hpp"
#include "roadway/layout.hpp"
#include "streetgen/arc_road.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

constexpr double sharpest_turn = M_PI / 2;  // beyond it no edge goes on from another
constexpr double share_of_segment = 0.25;   // of the segment at a node, for its tangent
constexpr double least_piece = 1e-3;        // metres

// Where an edge leaves its node: unit.
Point leaving(const Network& network, const EdgeEnd& end) {
  const Line& line = network.edges[end.edge].line;
  return end.at_start ? unit(planar(line[1]) - planar(line[0]))
                      : unit(planar(line[line.size() - 2]) - planar(line.back()));
}

double first_segment(const Network& network, const EdgeEnd& end) {
  const Line& line = network.edges[end.edge].line;
  return end.at_start ? distance(line[0], line[1]) : distance(line[line.size() - 2], line.back());
}

// The second point of an edge that leaves its node along the tangent of both edges there.
std::optional<Point> tangent_point(const Network& network, const EdgeEnd& own, const EdgeEnd& other,
                                   double shift) {
  if (network.edges[own.edge].level != network.edges[other.edge].level) return std::nullopt;
  const Point out = leaving(network, own), in = leaving(network, other) * -1;
  const double turn = std::abs(std::atan2(cross(in, out), dot(in, out)));
  if (turn < 1e-9 || turn > sharpest_turn) return std::nullopt;
  const double along =
      std::min(share_of_segment * first_segment(network, own), shift / std::sin(turn / 2));
  if (along < least_piece) return std::nullopt;
  const Line& line = network.edges[own.edge].line;
  return planar(own.at_start ? line.front() : line.back()) + unit(in + out) * along;
}

// By node, of those where two ends meet.
std::vector<std::vector<EdgeEnd>> ends_by_node(const Network& network) {
  std::vector<std::vector<EdgeEnd>> ends(network.nodes.size());
  for (int e = 0; e < static_cast<int>(network.edges.size()); ++e) {
    ends[network.edges[e].from_node].push_back({e, true});
    ends[network.edges[e].to_node].push_back({e, false});
  }
  return ends;
}

// With the heights of the line that it was made of, at the same share of the length.
Line with_heights(Line smooth, const Line& line) {
  const double share = length(line) / length(smooth);
  double abscissa = 0;
  for (std::size_t i = 0; i < smooth.size(); ++i) {
    if (i > 0) abscissa += distance(smooth[i - 1], smooth[i]);
    smooth[i].z = position_at(line, abscissa * share).point.z;
  }
  smooth.front() = line.front();
  smooth.back() = line.back();
  return smooth;
}

}  // namespace

void smooth_edges(Network& network, const Smoothing& smoothing) {
  const auto ends = ends_by_node(network);
  const auto tangent_at = [&](int node, const EdgeEnd& own) -> std::optional<Point> {
    if (ends[node].size() != 2) return std::nullopt;
    const EdgeEnd& first = ends[node][0];
    const EdgeEnd& other = slot(first) == slot(own) ? ends[node][1] : first;
    return tangent_point(network, own, other, smoothing.shift);
  };
  std::vector<Line> smooth;
  smooth.reserve(network.edges.size());
  for (int e = 0; e < static_cast<int>(network.edges.size()); ++e) {
    poll_cancel();
    const Edge& edge = network.edges[e];
    Line bends = distinct(planar(edge.line));
    if (const auto point = tangent_at(edge.from_node, {e, true}))
      bends.insert(bends.begin() + 1, *point);
    if (const auto point = tangent_at(edge.to_node, {e, false}))
      bends.insert(bends.end() - 1, *point);
    const bool straight = bends.size() == 2;
    ArcRoadFit fit;
    fit.shift = smoothing.shift;
    smooth.push_back(
        straight ? edge.line
                 : with_heights(ArcRoad::fit(bends, fit).line(smoothing.tolerance), edge.line));
  }
  for (std::size_t e = 0; e < smooth.size(); ++e) network.edges[e].line = std::move(smooth[e]);
}

}  // namespace streetgen
