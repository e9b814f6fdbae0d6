// The rows of subject network.
#include <utility>

#include "model/row_value.hpp"
#include "model/streets_give.hpp"

namespace streetgen::pg {

namespace {

using Computed = const ComputedStreets&;

const char* issue_name(NetworkIssue issue) {
  switch (issue) {
    case NetworkIssue::wide_cluster:
      return "wide_cluster";
    case NetworkIssue::crossing:
      return "crossing";
    case NetworkIssue::collapsed_axis:
      return "collapsed_axis";
    case NetworkIssue::lies_on_another:
      return "axis lies on another";
    case NetworkIssue::misses:
      return "end of an axis in the roadway of another, without a node";
  }
  return "";
}

bool lanes_affected(const Streets& streets, const Edge& edge) {
  return streets.affected_nodes[edge.from_node] || streets.affected_nodes[edge.to_node];
}

bool marked(const std::vector<bool>& marks, std::size_t i) { return !marks.empty() && marks[i]; }

// A network without streets says nothing of what lies beside it.
Beside side(const Streets& streets, std::size_t slot) {
  const std::vector<Beside>& sides = streets.beside.sides;
  return sides.empty() ? Beside::outer : sides[slot];
}

std::vector<double> medians(const Streets& streets, std::size_t slot) {
  const auto& all = streets.beside.medians;
  return all.empty() ? std::vector<double>{} : all[slot];
}

bool fill_node(const ComputedStreets& computed, const Named&, std::size_t i, Row& row) {
  const auto& node = computed.streets.network.nodes[i];
  std::vector<std::int64_t> axes;
  std::vector<double> abscissas;
  for (const NodeAnchor& anchor : node.anchors) {
    axes.push_back(anchor.axis_id);
    abscissas.push_back(anchor.abscissa);
  }
  return put(
      row, bool(computed.streets.affected_nodes[i]), marked(computed.streets.nodes_with_kerbs, i),
      Geometry{stored_point(node.point, with_z(computed))}, std::move(axes), std::move(abscissas));
}

bool fill_edge(const ComputedStreets& computed, const Named&, std::size_t i, Row& row) {
  const Edge& edge = computed.streets.network.edges[i];
  Value curve;
  if (!edge.curve.empty()) curve = Ewkb{write_curve(edge.curve, flat(computed))};
  return put(row, bool(computed.streets.affected_edges[i]), lanes_affected(computed.streets, edge),
             marked(computed.streets.edges_with_kerbs, i), bool(computed.streets.spreads_to[i]),
             edge.axis_id, number(edge.from_node), number(edge.to_node), edge.level,
             edge.start_abscissa, edge.end_abscissa,
             Geometry{stored_line(edge.line, with_z(computed))}, std::move(curve),
             name(beside_name(side(computed.streets, 2 * i))),
             name(beside_name(side(computed.streets, 2 * i + 1))), medians(computed.streets, 2 * i),
             medians(computed.streets, 2 * i + 1));
}

bool fill_report(const ComputedStreets& computed, const Named&, std::size_t i, Row& row) {
  const NetworkReport& report = computed.streets.network.reports[i];
  return put(row, name(issue_name(report.issue)), report.axis_a, report.axis_b, report.measure,
             Geometry{stored_point(report.point, flat(computed))});
}

const Table node_table{[](Computed c) { return c.streets.network.nodes.size(); }, fill_node};
const Table edge_table{[](Computed c) { return c.streets.network.edges.size(); }, fill_edge};
const Table report_table{[](Computed c) { return c.streets.network.reports.size(); }, fill_report};

}  // namespace

STREETGEN_TABLE(node)
STREETGEN_TABLE(edge)
STREETGEN_TABLE(report)

}  // namespace streetgen::pg
