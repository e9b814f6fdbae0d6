#include "ownership/claim.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"

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
std::int64_t order_key_at(double abscissa) { return 2 * std::llround(1000 * abscissa); }

// Where the edge's line begins, metres along its axis, told from its first vertex between its ends:
// those lie beside the axis where others meet it, and must not move what is measured beyond.
double first_abscissa(const Layout& layout, int e) {
  const Edge& edge = layout.streets.network.edges[e];
  const Line& axis = layout.axis_of(e).line;
  double abscissa = 0;
  for (std::size_t i = 1; i < axis.size() && abscissa < edge.end_abscissa; ++i) {
    abscissa += distance(axis[i - 1], axis[i]);
    if (abscissa > edge.start_abscissa && distance(axis[i], edge.line[1]) == 0)
      return abscissa - distance(edge.line[0], edge.line[1]);
  }
  return edge.start_abscissa;
}

}  // namespace

Claim claim_of_section(const Layout& layout, int e) {
  const Edge& edge = layout.streets.network.edges[e];
  const double start = layout.streets.limits[2 * e].abscissa,
               end = layout.streets.limits[2 * e + 1].abscissa;
  Claim claim;
  claim.wanted = layout.streets.affected_edges[e];
  claim.level = edge.level;
  claim.axis_id = edge.axis_id;
  claim.order_key = order_key_at(edge.start_abscissa) + 1;
  if (start < end)
    claim.skeleton.push_back({&layout.arms[2 * e].line, start, end, first_abscissa(layout, e)});
  add_axis(claim, layout, e);
  return claim;
}

Claim claim_of_intersection(const Layout& layout, int node) {
  const NodeAnchor& anchor = layout.streets.network.nodes[node].anchors.front();
  Claim claim;
  claim.wanted = layout.streets.affected_nodes[node];
  claim.level = layout.level_of(node);
  claim.axis_id = anchor.axis_id;
  claim.order_key = order_key_at(anchor.abscissa);
  claim.node = layout.streets.network.nodes[node].point;
  for (const EdgeEnd& end : layout.junctions[node].ends) {
    const Line& along = layout.arms[2 * end.edge].line;
    const double limit = layout.arm(end).limit, total = length(along);
    if (limit > 0)
      claim.skeleton.push_back({&along, end.at_start ? 0 : total - limit,
                                end.at_start ? limit : total, first_abscissa(layout, end.edge)});
    add_axis(claim, layout, end.edge);
    claim.joins_levels |= layout.streets.network.edges[end.edge].level != claim.level;
  }
  return claim;
}

}  // namespace streetgen
