#include "layout/smooth_edges.hpp"

#include <vector>

#include "geometry/polyline.hpp"
#include "road/edge_arcs.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

Line with_heights(Line drawn, const Line& line) {
  const double share = length(line) / length(drawn);
  double abscissa = 0;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    if (i > 0) abscissa += distance(drawn[i - 1], drawn[i]);
    drawn[i].z = position_at(line, abscissa * share).point.z;
  }
  drawn.front() = line.front();
  drawn.back() = line.back();
  return drawn;
}

void smooth_edges(Network& network, const Smoothing& smoothing,
                  const std::vector<RoadOverride>& overrides) {
  const EdgeArcs arcs(network, ends_by_node(network), smoothing.shift, overrides);
  std::vector<std::optional<ArcRoad>> smooth;
  smooth.reserve(network.edges.size());
  for (int e = 0; e < static_cast<int>(network.edges.size()); ++e) {
    poll_cancel();
    smooth.push_back(arcs.of(e));
  }
  for (std::size_t e = 0; e < smooth.size(); ++e) {
    if (!smooth[e]) continue;
    Edge& edge = network.edges[e];
    edge.curve = smooth[e]->curve();
    edge.line = with_heights(smooth[e]->line(smoothing.tolerance), edge.line);
  }
}

}  // namespace streetgen
