#include "claims.hpp"

#include <algorithm>
#include <cmath>

#include "polyline.hpp"

namespace streetgen {

namespace {

void add_axis(Claim& claim, const Layout& layout, int edge) {
  const StreetAxis& axis = layout.axis_of(edge);
  claim.edges.push_back(edge);
  claim.importance = std::min(claim.importance, axis.importance);
  claim.width = std::max({claim.width, axis.width, axis.width_end});
  claim.axis_id = std::min(claim.axis_id, axis.axis_id);
}

// Twice the millimetres: sections lie at odd places, nodes at even ones.
std::int64_t place_of(double abscissa) { return 2 * std::llround(1000 * abscissa); }

}  // namespace

Claim claim_of_section(const Layout& layout, int e) {
  const Edge& edge = layout.streets.network.edges[e];
  const double start = layout.streets.limits[2 * e].abscissa,
               end = layout.streets.limits[2 * e + 1].abscissa;
  Claim claim;
  claim.wanted = layout.streets.asked_edges[e];
  claim.level = edge.level;
  claim.axis_id = edge.axis_id;
  claim.place = place_of(edge.start_abscissa) + 1;
  if (start < end) claim.skeleton.push_back({&layout.arms[2 * e].line, start, end});
  add_axis(claim, layout, e);
  return claim;
}

Claim claim_of_intersection(const Layout& layout, int node) {
  const NodeAnchor& anchor = layout.streets.network.nodes[node].anchors.front();
  Claim claim;
  claim.wanted = layout.streets.asked_nodes[node];
  claim.level = layout.level_of(node);
  claim.axis_id = anchor.axis_id;
  claim.place = place_of(anchor.abscissa);
  claim.node = layout.streets.network.nodes[node].point;
  for (const EdgeEnd& end : layout.junctions[node].ends) {
    const Line& along = layout.arms[2 * end.edge].line;
    const double limit = layout.arm(end).limit, total = length(along);
    if (limit > 0)
      claim.skeleton.push_back(
          {&along, end.at_start ? 0 : total - limit, end.at_start ? limit : total});
    add_axis(claim, layout, end.edge);
    claim.joins_levels |= layout.streets.network.edges[end.edge].level != claim.level;
  }
  return claim;
}

}  // namespace streetgen
