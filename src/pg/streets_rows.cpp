#include "streets_rows.hpp"

#include <unordered_set>

#include "lane_text.hpp"
#include "wkb.hpp"

namespace streetgen::pg {

namespace {

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

Row& add(Rows& rows, const char* relation) {
  rows.emplace_back();
  rows.back().relation = relation;
  return rows.back();
}

void append_network(const Streets& streets, Form with_z, Form flat, Rows& rows) {
  const Network& network = streets.network;
  for (std::size_t i = 0; i < network.nodes.size(); ++i) {
    Row& row = add(rows, "node");
    row.row_index = static_cast<int>(i);
    row.start_a = streets.asked_nodes[i];
    row.geom_1 = write_point(network.nodes[i].point, with_z);
    for (const NodeAnchor& anchor : network.nodes[i].anchors) {
      row.anchor_axis.push_back(anchor.axis_id);
      row.anchor_abscissa.push_back(anchor.abscissa);
    }
  }
  for (std::size_t i = 0; i < network.edges.size(); ++i) {
    const Edge& edge = network.edges[i];
    Row& row = add(rows, "edge");
    row.row_index = static_cast<int>(i);
    row.axis_id = edge.axis_id;
    row.node_a = edge.from_node;
    row.node_b = edge.to_node;
    row.start_a = streets.asked_edges[i];
    row.start_b = streets.asked_nodes[edge.from_node] || streets.asked_nodes[edge.to_node];
    row.level = edge.level;
    row.measure_1 = edge.start_abscissa;
    row.measure_2 = edge.end_abscissa;
    row.geom_1 = write_line(edge.line, with_z);
  }
  for (const NetworkReport& report : network.reports) {
    Row& row = add(rows, "report");
    row.axis_id = report.axis_a;
    row.anchor_axis = {report.axis_b};
    row.measure_1 = report.measure;
    row.geom_1 = write_point(report.point, flat);
    row.method = issue_name(report.issue);
  }
}

// The edges of axes that have an asked edge, or one at an asked node: rows of others are not written.
std::vector<bool> edges_of_asked_axes(const Streets& streets) {
  const auto& edges = streets.network.edges;
  std::unordered_set<std::int64_t> asked;
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (streets.asked_edges[e] || streets.asked_nodes[edges[e].from_node] ||
        streets.asked_nodes[edges[e].to_node])
      asked.insert(edges[e].axis_id);
  std::vector<bool> written;
  for (const Edge& edge : edges) written.push_back(asked.count(edge.axis_id) > 0);
  return written;
}

void append_streets(const Streets& streets, Form with_z, Form flat, Rows& rows) {
  const std::vector<bool> written = edges_of_asked_axes(streets);
  for (const SectionLimit& limit : streets.limits) {
    if (!written[limit.edge]) continue;
    Row& row = add(rows, "section_limit");
    row.edge_a = limit.edge;
    row.start_a = limit.at_start;
    row.measure_1 = limit.wanted_abscissa;
    row.measure_2 = limit.abscissa;
    row.geom_1 = write_point(limit.point, with_z);
    row.geom_2 = write_line(limit.border_line, flat);
    row.method = method_name(limit.method);
  }
  for (const Corner& corner : streets.corners) {
    if (!written[corner.edge_a] || !written[corner.edge_b]) continue;
    Row& row = add(rows, "corner");
    row.row_index = static_cast<int>(rows.size());
    row.node_a = corner.node;
    row.edge_a = corner.edge_a;
    row.start_a = corner.at_start_a;
    row.edge_b = corner.edge_b;
    row.start_b = corner.at_start_b;
    row.measure_1 = corner.radius_wanted;
    row.measure_2 = corner.radius;
    if (corner.centre) row.geom_1 = write_point(*corner.centre, flat);
    if (corner.arc) row.geom_2 = write_arc(*corner.arc, flat);
    row.method = method_name(corner.method);
  }
  for (const Section& section : streets.sections) {
    Row& row = add(rows, "section");
    row.edge_a = section.edge;
    row.level = streets.network.edges[section.edge].level;
    row.measure_1 = section.contested_area;
    row.geom_1 = write_surface(section.surface, flat);
    row.method = method_name(section.method);
  }
  for (const Intersection& intersection : streets.intersections) {
    Row& row = add(rows, "intersection");
    row.node_a = intersection.node;
    row.level = intersection.level;
    row.measure_1 = intersection.contested_area;
    row.geom_1 = write_surface(intersection.surface, flat);
    row.method = method_name(intersection.method);
  }
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

void append_lanes(const Lanes& lanes, Form flat, Rows& rows) {
  for (std::size_t i = 0; i < lanes.lanes.size(); ++i) {
    const Lane& lane = lanes.lanes[i];
    Row& row = add(rows, "lane");
    row.row_index = static_cast<int>(i);
    row.edge_a = lane.edge;
    row.start_a = lane.along_axis;
    row.measure_1 = lane.width;
    row.measure_2 = lane.axis_offset;
    row.geom_1 = write_line(lane.line, flat);
    row.geom_2 = write_surface(lane.surface, flat);
    row.method = method_name(lane.method);
    row.lane_position = lane.position;
    row.ordinality = lane.ordinality;
    row.side = lane_side_name(lane.side);
    row.kind = lane_kind_name(lane.kind);
    row.turn = turn_text(lane.turns);
  }
  for (const LaneSeparator& separator : lanes.separators) {
    Row& row = add(rows, "lane_separator");
    row.edge_a = separator.edge;
    row.start_a = separator.dashed;
    row.measure_2 = separator.axis_offset;
    row.geom_1 = write_line(separator.line, flat);
    row.geom_2 = write_surface(separator.surface, flat);
    row.lane_position = separator.position;
    row.kind = separator_kind_name(separator.kind);
  }
  for (const Marking& marking : lanes.markings) {
    Row& row = add(rows, "marking");
    row.edge_a = marking.edge;
    row.node_a = marking.node;
    row.geom_1 = write_line(marking.line, flat);
    row.geom_2 = write_surface(marking.surface, flat);
    row.lane_position = marking.position;
    row.kind = marking_kind_name(marking.kind);
  }
}

void append_interconnections(const std::vector<Interconnection>& interconnections, Form flat,
                             Rows& rows) {
  for (std::size_t i = 0; i < interconnections.size(); ++i) {
    const Interconnection& pair = interconnections[i];
    Row& row = add(rows, "interconnection");
    row.row_index = static_cast<int>(i);
    row.node_a = pair.node;
    row.edge_a = pair.lane_in;
    row.edge_b = pair.lane_out;
    row.start_a = pair.plausible;
    row.measure_1 = pair.angle;
    row.geom_1 = write_line(pair.line, flat);
    row.geom_2 = write_point(pair.control, flat);
    row.turn = turn_name(pair.turn);
    row.kind = reason_name(pair.reason);
  }
}

}  // namespace

Rows rows_of(const Streets& streets, const Lanes& lanes,
             const std::vector<Interconnection>& interconnections, int srid, bool has_z) {
  const Form with_z{srid, has_z}, flat{srid, false};
  Rows rows;
  append_network(streets, with_z, flat, rows);
  append_streets(streets, with_z, flat, rows);
  append_lanes(lanes, flat, rows);
  append_interconnections(interconnections, flat, rows);
  return rows;
}

}  // namespace streetgen::pg
