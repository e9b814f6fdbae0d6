#include "ownership/street_claim.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"

namespace streetgen {

namespace {

void add_axis(Claim& claim, const Layout& layout, int edge) {
  const StreetAxis& axis = layout.axis_of(edge);
  claim.edges.push_back(edge);
  claim.importance = std::min(claim.importance, axis.importance);
  claim.width = std::max({claim.width, axis.width, axis.width_end});
  const std::int64_t size = layout.axis_lengths[edge];
  auto& sizes = claim.axis_lengths;
  sizes.insert(std::upper_bound(sizes.begin(), sizes.end(), size, std::greater<>()), size);
  claim.axis_id = std::min(claim.axis_id, axis.axis_id);
}

// Twice the millimetres: sections lie at odd places, nodes at even ones.
std::int64_t order_key_at(double abscissa) { return 2 * std::llround(1000 * abscissa); }

// The segments of its axis that the edge's line begins and ends in: those at whose other ends its
// line has a vertex.  Its ends lie beside the axis where others meet it.
EndSegments end_segments(const Layout& layout, int e) {
  const Edge& edge = layout.streets.network.edges[e];
  const Line &axis = layout.axis_of(e).line, &line = edge.line;
  EndSegments ends;
  double abscissa = 0;
  for (std::size_t i = 1; i < axis.size(); ++i) {
    const double size = distance(axis[i - 1], axis[i]), begin = abscissa;
    abscissa += size;
    if (ends.first == 0 && abscissa > edge.start_abscissa + same_place) {
      if (line.size() > 2 && distance(axis[i], line[1]) > 0) return {};
      ends.first = size;
      ends.before = std::max(0.0, edge.start_abscissa - begin);
    }
    if (abscissa < edge.end_abscissa - same_place) continue;
    if (line.size() > 2 && distance(axis[i - 1], line[line.size() - 2]) > 0) return {};
    ends.last = size;
    ends.beyond = std::max(0.0, abscissa - edge.end_abscissa);
    break;
  }
  return ends;
}

void add_stretch(Claim& claim, const Layout& layout, int edge, double from, double to) {
  claim.skeleton.push_back({&layout.arms[2 * edge].line, from, to, end_segments(layout, edge)});
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
  if (start < end) add_stretch(claim, layout, e, start, end);
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
    const double limit = layout.arm(end).limit, total = length(layout.arms[2 * end.edge].line);
    if (limit > 0)
      add_stretch(claim, layout, end.edge, end.at_start ? 0 : total - limit,
                  end.at_start ? limit : total);
    add_axis(claim, layout, end.edge);
    claim.joins_levels |= layout.streets.network.edges[end.edge].level != claim.level;
  }
  return claim;
}

}  // namespace streetgen
