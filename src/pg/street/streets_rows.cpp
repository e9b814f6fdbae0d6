#include "street/streets_rows.hpp"

#include <utility>

#include "value/lane_text.hpp"

namespace streetgen::pg {

namespace {

Form flat(const ComputedStreets& computed) { return {computed.srid, false}; }
Form with_z(const ComputedStreets& computed) { return {computed.srid, computed.has_z}; }

// Before they have ids, nodes and edges refer to each other by numbers from 1 on.
std::int32_t number(std::size_t index) { return static_cast<std::int32_t>(index) + 1; }
std::string_view end_name(bool at_start) { return at_start ? "start" : "end"; }
std::string_view name(const char* text) { return text; }

const char* issue_name(NetworkIssue issue) {
  switch (issue) {
    case NetworkIssue::wide_cluster:
      return "wide_cluster";
    case NetworkIssue::crossing:
      return "crossing";
    case NetworkIssue::collapsed_axis:
      return "collapsed_axis";
  }
  return "";
}

const char* separator_kind_name(SeparatorKind kind) {
  switch (kind) {
    case SeparatorKind::centre:
      return "centre";
    case SeparatorKind::same_direction:
      return "same_direction";
    case SeparatorKind::edge:
      return "edge";
  }
  return "";
}

const char* marking_kind_name(MarkingKind kind) {
  switch (kind) {
    case MarkingKind::stop:
      return "stop";
    case MarkingKind::yield:
      return "yield";
    case MarkingKind::arrow:
      return "arrow";
  }
  return "";
}

template <class... Values>
bool put(Row& row, Values&&... values) {
  row.clear();
  (row.emplace_back(std::forward<Values>(values)), ...);
  return true;
}

bool lanes_asked(const Streets& streets, const Edge& edge) {
  return streets.asked_nodes[edge.from_node] || streets.asked_nodes[edge.to_node];
}

bool fill_node(const ComputedStreets& computed, const Named&, std::size_t i, Row& row) {
  const auto& node = computed.streets.network.nodes[i];
  std::vector<std::int64_t> axes;
  std::vector<double> abscissas;
  for (const NodeAnchor& anchor : node.anchors) {
    axes.push_back(anchor.axis_id);
    abscissas.push_back(anchor.abscissa);
  }
  return put(row, computed.streets.asked_nodes[i],
             Geometry{stored_point(node.point, with_z(computed))}, std::move(axes),
             std::move(abscissas));
}

bool fill_edge(const ComputedStreets& computed, const Named&, std::size_t i, Row& row) {
  const Edge& edge = computed.streets.network.edges[i];
  return put(row, bool(computed.streets.asked_edges[i]), lanes_asked(computed.streets, edge),
             bool(computed.streets.leading_on[i]), edge.axis_id, number(edge.from_node),
             number(edge.to_node), edge.level, edge.start_abscissa, edge.end_abscissa,
             Geometry{stored_line(edge.line, with_z(computed))});
}

bool fill_section_limit(const ComputedStreets& computed, const Named& named, std::size_t i,
                        Row& row) {
  const SectionLimit& limit = computed.streets.limits[i];
  const std::int64_t edge = named.edges[limit.edge];
  return edge > 0 && put(row, edge, computed.streets.network.edges[limit.edge].axis_id,
                         end_name(limit.at_start), limit.wanted_abscissa, limit.abscissa,
                         Geometry{stored_point(limit.point, with_z(computed))},
                         Geometry{stored_line(limit.border_line, flat(computed))},
                         name(method_name(limit.method)));
}

bool fill_section(const ComputedStreets& computed, const Named& named, std::size_t i, Row& row) {
  const Section& section = computed.streets.sections[i];
  const std::int64_t edge = named.edges[section.edge];
  return edge > 0 && put(row, edge, computed.streets.network.edges[section.edge].level,
                         Geometry{stored_surface(section.surface, flat(computed))},
                         name(method_name(section.method)), section.contested_area);
}

bool fill_corner(const ComputedStreets& computed, const Named& named, std::size_t i, Row& row) {
  const Corner& corner = computed.streets.corners[i];
  const std::int64_t node = named.nodes[corner.node];
  const std::int64_t edge_a = named.edges[corner.edge_a], edge_b = named.edges[corner.edge_b];
  if (node == 0 || edge_a == 0 || edge_b == 0) return false;
  Value centre, arc;
  if (corner.centre) centre = Geometry{stored_point(*corner.centre, flat(computed))};
  if (corner.arc) arc = Ewkb{write_arc(*corner.arc, flat(computed))};
  return put(row, node, edge_a, end_name(corner.at_start_a), edge_b, end_name(corner.at_start_b),
             std::move(centre), corner.radius_wanted, corner.radius, std::move(arc),
             name(method_name(corner.method)));
}

bool fill_intersection(const ComputedStreets& computed, const Named& named, std::size_t i,
                       Row& row) {
  const Intersection& intersection = computed.streets.intersections[i];
  const std::int64_t node = named.nodes[intersection.node];
  return node > 0 && put(row, node, intersection.level,
                         Geometry{stored_surface(intersection.surface, flat(computed))},
                         name(method_name(intersection.method)), intersection.contested_area);
}

bool fill_lane(const ComputedStreets& computed, const Named& named, std::size_t i, Row& row) {
  const Lane& lane = computed.lanes.lanes[i];
  const std::int64_t edge = named.edges[lane.edge];
  if (edge == 0) return false;
  Value turn;
  if (lane.turns != 0) turn = turn_text(lane.turns);
  return put(row, edge, computed.streets.network.edges[lane.edge].axis_id, lane.ordinality,
             lane.position, name(lane_side_name(lane.side)), lane.along_axis, lane.both_ways,
             name(lane_kind_name(lane.kind)), lane.width, lane.axis_offset, std::move(turn),
             Geometry{stored_line(lane.line, flat(computed))},
             Geometry{stored_surface(lane.surface, flat(computed))},
             name(method_name(lane.method)));
}

bool fill_lane_separator(const ComputedStreets& computed, const Named& named, std::size_t i,
                         Row& row) {
  const LaneSeparator& separator = computed.lanes.separators[i];
  const std::int64_t edge = named.edges[separator.edge];
  return edge > 0 && put(row, edge, separator.position, name(separator_kind_name(separator.kind)),
                         separator.dashed, separator.axis_offset,
                         Geometry{stored_line(separator.line, flat(computed))},
                         Geometry{stored_surface(paint_of(separator), flat(computed))});
}

bool fill_marking(const ComputedStreets& computed, const Named& named, std::size_t i, Row& row) {
  const Marking& marking = computed.lanes.markings[i];
  const std::int64_t edge = named.edges[marking.edge];
  return edge > 0 && put(row, edge, marking.position, marking.along_axis, named.nodes[marking.node],
                         name(marking_kind_name(marking.kind)),
                         Geometry{stored_line(marking.line, flat(computed))},
                         Geometry{stored_surface(marking.surface, flat(computed))});
}

bool fill_interconnection(const ComputedStreets& computed, const Named& named, std::size_t i,
                          Row& row) {
  const Interconnection& pair = computed.interconnections[i];
  const std::int64_t node = named.nodes[pair.node];
  const std::int64_t lane_in = named.lanes[pair.lane_in], lane_out = named.lanes[pair.lane_out];
  if (node == 0 || lane_in == 0 || lane_out == 0) return false;
  return put(row, node, lane_in, lane_out, pair.along_in, pair.along_out,
             name(turn_name(pair.turn)), pair.angle, pair.plausible, name(reason_name(pair.reason)),
             Geometry{stored_point(pair.control, flat(computed))},
             Geometry{stored_line(pair.line, flat(computed))});
}

bool fill_report(const ComputedStreets& computed, const Named&, std::size_t i, Row& row) {
  const NetworkReport& report = computed.streets.network.reports[i];
  return put(row, name(issue_name(report.issue)), report.axis_a, report.axis_b, report.measure,
             Geometry{stored_point(report.point, flat(computed))});
}

}  // namespace

using Computed = const ComputedStreets&;

template <class T>
void release(std::vector<T>& rows) {
  std::vector<T>().swap(rows);
}

const Table node_table{[](Computed c) { return c.streets.network.nodes.size(); }, fill_node};
const Table edge_table{[](Computed c) { return c.streets.network.edges.size(); }, fill_edge};
const Table section_limit_table{[](Computed c) { return c.streets.limits.size(); },
                                fill_section_limit,
                                [](ComputedStreets& c) { release(c.streets.limits); }};
const Table section_table{[](Computed c) { return c.streets.sections.size(); }, fill_section,
                          [](ComputedStreets& c) { release(c.streets.sections); }};
const Table corner_table{[](Computed c) { return c.streets.corners.size(); }, fill_corner,
                         [](ComputedStreets& c) { release(c.streets.corners); }};
const Table intersection_table{[](Computed c) { return c.streets.intersections.size(); },
                               fill_intersection,
                               [](ComputedStreets& c) { release(c.streets.intersections); }};
const Table lane_table{[](Computed c) { return c.lanes.lanes.size(); }, fill_lane,
                       [](ComputedStreets& c) { release(c.lanes.lanes); }};
const Table lane_separator_table{[](Computed c) { return c.lanes.separators.size(); },
                                 fill_lane_separator,
                                 [](ComputedStreets& c) { release(c.lanes.separators); }};
const Table marking_table{[](Computed c) { return c.lanes.markings.size(); }, fill_marking,
                          [](ComputedStreets& c) { release(c.lanes.markings); }};
const Table interconnection_table{[](Computed c) { return c.interconnections.size(); },
                                  fill_interconnection};
const Table report_table{[](Computed c) { return c.streets.network.reports.size(); }, fill_report};

}  // namespace streetgen::pg
