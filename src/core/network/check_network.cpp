#include "network/check_network.hpp"

#include "geometry/polyline.hpp"
#include "support/invariant.hpp"

namespace streetgen {

void check_network(const Network& network) {
  if (!invariants_are_checked) return;
  for (std::size_t e = 0; e < network.edges.size(); ++e) {
    const Edge& edge = network.edges[e];
    must_hold(edge.line.size() > 1, "an edge has two points or more", e);
    must_hold(same(edge.line.front(), network.nodes.at(edge.from_node).point) &&
                  same(edge.line.back(), network.nodes.at(edge.to_node).point),
              "an edge starts and ends at its nodes", e);
    must_hold(edge.start_abscissa < edge.end_abscissa, "abscissas grow along an edge", e);
    must_hold(e == 0 || network.edges[e - 1].axis_id != edge.axis_id ||
                  network.edges[e - 1].end_abscissa <= edge.start_abscissa,
              "the edges of an axis follow each other", e);
  }
}

}  // namespace streetgen
