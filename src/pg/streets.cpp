// streetgen._streets: the whole pipeline over a set of axes, one row per result.
#include "streetgen/streets.hpp"

#include <map>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "argument.hpp"
#include "border.hpp"
#include "lane_text.hpp"
#include "streetgen/interconnection.hpp"
#include "streetgen/lane.hpp"
#include "wkb.hpp"

extern "C" {
#include <catalog/pg_type.h>
#include <funcapi.h>
#include <utils/array.h>
#include <utils/builtins.h>
#include <utils/lsyscache.h>
#include <utils/tuplestore.h>
}

namespace streetgen::pg {
namespace {

// One row of the result, in plain values: what the give step reads.
struct Row {
  const char* relation = "";
  int row_index = 0;
  std::int64_t axis_id = 0;
  int node_a = -1, node_b = -1, edge_a = -1, edge_b = -1;  // -1: NULL
  bool start_a = false, start_b = false;
  int level = 0;
  double measure_1 = 0, measure_2 = 0;
  std::string geom_1, geom_2;  // empty: NULL
  std::vector<std::int64_t> anchor_axis;
  std::vector<double> anchor_abscissa;
  const char* method = "";
  int lane_position = -1, ordinality = -1;  // -1: NULL
  std::string side, kind, turn;             // empty: NULL
};
using Rows = std::vector<Row>;

// What the take step found: PostgreSQL's memory, plain pointers.
struct Taken {
  int count;
  Datum *axis_id, *geom, *width, *width_end, *radius, *importance, *level;
  int srid;
  double tolerance, max_arc_distance, radius_minimal, transition_length, max_hole_area, reach;
  const char *crossing, *transition_kind, *radius_rule, *short_axis;
  bool round_dead_ends;
  int transition_count;
  Datum *transition_axis, *transition_which, *transition_kind_of, *transition_length_of;
  Datum *lanes_forward, *lanes_backward;
  Datum *turn_forward, *turn_backward, *kind_forward, *kind_backward;
  Datum *lane_width_forward, *lane_width_backward;
  int override_count;
  Datum *override_axis, *override_abscissa, *override_ordinality, *override_direction;
  Datum* override_width;
  const char *lane_order, *driving_side;
  double lane_width_minimal, cycle_lane_width, parking_lane_width;
  bool edge_lines;
  Datum* speed;
  int restriction_count;
  Datum *restriction_from, *restriction_to, *restriction_x, *restriction_y;
  Datum *restriction_kind, *restriction_turn;
  bool u_turn;
  const char* trajectory;
  double trajectory_tolerance, trajectory_radius;
};

std::string text_of(Datum datum) {
  const auto* text = reinterpret_cast<const struct varlena*>(DatumGetPointer(datum));
  return {VARDATA_ANY(text), VARSIZE_ANY_EXHDR(text)};
}

TransitionKind transition_kind_of(const char* word) {
  return word_of<TransitionKind>(word, "transition_kind",
                                 {{"symmetric", TransitionKind::symmetric},
                                  {"left", TransitionKind::left},
                                  {"right", TransitionKind::right}});
}

// Its own transitions, by axis and whether at the axis' start.
std::map<std::pair<std::int64_t, bool>, Transition> transitions_of(const Taken& taken) {
  std::map<std::pair<std::int64_t, bool>, Transition> transitions;
  for (int i = 0; i < taken.transition_count; ++i) {
    const std::int64_t axis_id = DatumGetInt64(taken.transition_axis[i]);
    const bool at_start = word_of<bool>(text_of(taken.transition_which[i]), "transition end",
                                        {{"start", true}, {"end", false}});
    const double length = in_range(DatumGetFloat8(taken.transition_length_of[i]), 0, 1000,
                                   "transition length of axis " + std::to_string(axis_id));
    transitions[{axis_id, at_start}] = {
        transition_kind_of(text_of(taken.transition_kind_of[i]).c_str()), length};
  }
  return transitions;
}

std::vector<StreetAxis> axes_of(const Taken& taken, bool* has_z) {
  std::vector<StreetAxis> axes;
  std::unordered_set<std::int64_t> seen;
  const auto transitions = transitions_of(taken);
  const auto own = [&](std::int64_t axis_id, bool at_start) {
    const auto found = transitions.find({axis_id, at_start});
    return found == transitions.end() ? std::nullopt : std::optional(found->second);
  };
  for (int i = 0; i < taken.count; ++i) {
    StreetAxis axis;
    axis.axis_id = DatumGetInt64(taken.axis_id[i]);
    const std::string of_axis = " of axis " + std::to_string(axis.axis_id);
    if (!seen.insert(axis.axis_id).second)
      throw Error(ErrorKind::invalid_input,
                  "axis " + std::to_string(axis.axis_id) + " stands more than once in the list");
    const auto* wkb = reinterpret_cast<const struct varlena*>(DatumGetPointer(taken.geom[i]));
    const ReadLine read =
        read_line({VARDATA_ANY(wkb), VARSIZE_ANY_EXHDR(wkb)}, "the geometry" + of_axis);
    if (read.srid != taken.srid)
      throw Error(ErrorKind::invalid_input, "the geometry" + of_axis + " has SRID " +
                                                std::to_string(read.srid) + ", expected " +
                                                std::to_string(taken.srid));
    *has_z = *has_z || read.has_z;
    axis.line = read.line;
    axis.width = in_range(DatumGetFloat8(taken.width[i]), 1e-3, 200, "width" + of_axis);
    axis.width_end = in_range(DatumGetFloat8(taken.width_end[i]), 1e-3, 200, "width_end" + of_axis);
    axis.radius = in_range(DatumGetFloat8(taken.radius[i]), 0, 1000, "radius" + of_axis);
    axis.importance = DatumGetInt32(taken.importance[i]);
    axis.level = DatumGetInt32(taken.level[i]);
    axis.speed = in_range(DatumGetFloat8(taken.speed[i]), 0, 1000, "speed" + of_axis);
    axis.transition_start = own(axis.axis_id, true);
    axis.transition_end = own(axis.axis_id, false);
    axes.push_back(std::move(axis));
  }
  return axes;
}

// streetgen._default_setting() has the range of each; here stands what the core can bear.
StreetSettings settings_of(const Taken& taken) {
  const auto measure = [](double value, const std::string& name, double low = 0) {
    return in_range(value, low, 1000, "setting " + name);
  };
  StreetSettings settings;
  settings.tolerance = measure(taken.tolerance, "tolerance", 1e-6);
  settings.crossing = word_of<Crossing>(taken.crossing, "crossing",
                                        {{"over", Crossing::over}, {"split", Crossing::split}});
  settings.max_arc_distance = measure(taken.max_arc_distance, "max_arc_distance");
  settings.radius_minimal = measure(taken.radius_minimal, "radius_minimal");
  settings.transition = {transition_kind_of(taken.transition_kind),
                         measure(taken.transition_length, "transition_length")};
  settings.radius_rule = word_of<RadiusRule>(
      taken.radius_rule, "radius_rule",
      {{"min", RadiusRule::min}, {"max", RadiusRule::max}, {"mean", RadiusRule::mean}});
  settings.round_dead_ends = taken.round_dead_ends;
  settings.max_hole_area = measure(taken.max_hole_area, "max_hole_area");
  settings.reach = measure(taken.reach, "reach");
  settings.short_axis =
      word_of<ShortAxis>(taken.short_axis, "short_axis",
                         {{"reduce", ShortAxis::reduce}, {"follow", ShortAxis::follow}});
  return settings;
}

std::vector<LanesOfAxis> lanes_of(const Taken& taken) {
  const KindWidths defaults{
      in_range(taken.cycle_lane_width, 0, 1000, "setting cycle_lane_width"),
      in_range(taken.parking_lane_width, 0, 1000, "setting parking_lane_width")};
  std::vector<LanesOfAxis> axes;
  for (int i = 0; i < taken.count; ++i) {
    const std::int64_t axis_id = DatumGetInt64(taken.axis_id[i]);
    const std::string of_axis = " of axis " + std::to_string(axis_id);
    const auto read = [&](Datum* count, Datum* kinds, Datum* widths, Datum* turns) {
      const int lanes =
          static_cast<int>(in_range(DatumGetInt32(count[i]), 0, 100, "lanes" + of_axis));
      return read_lanes(lanes, text_of(kinds[i]), text_of(widths[i]), text_of(turns[i]), defaults,
                        of_axis);
    };
    axes.push_back({axis_id,
                    {read(taken.lanes_forward, taken.kind_forward, taken.lane_width_forward,
                          taken.turn_forward),
                     read(taken.lanes_backward, taken.kind_backward, taken.lane_width_backward,
                          taken.turn_backward)}});
  }
  return axes;
}

std::vector<LaneOverride> overrides_of(const Taken& taken) {
  using Direction = LaneOverride::Direction;
  std::vector<LaneOverride> overrides;
  for (int i = 0; i < taken.override_count; ++i)
    overrides.push_back(
        {DatumGetInt64(taken.override_axis[i]), DatumGetFloat8(taken.override_abscissa[i]),
         DatumGetInt32(taken.override_ordinality[i]),
         word_of<Direction>(text_of(taken.override_direction[i]), "direction of a lane override",
                            {{"as_is", Direction::as_is},
                             {"along", Direction::along},
                             {"against", Direction::against}}),
         in_range(DatumGetFloat8(taken.override_width[i]), 0, 200, "width of a lane override")});
  return overrides;
}

LaneSettings lane_settings_of(const Taken& taken) {
  LaneSettings settings =
      read_lane_settings(taken.lane_order, taken.driving_side, taken.lane_width_minimal);
  settings.edge_lines = taken.edge_lines;
  return settings;
}

std::vector<TurnRestriction> restrictions_of(const Taken& taken) {
  std::vector<TurnRestriction> restrictions;
  for (int i = 0; i < taken.restriction_count; ++i) {
    TurnRestriction restriction;
    restriction.from_axis = DatumGetInt64(taken.restriction_from[i]);
    restriction.to_axis = DatumGetInt64(taken.restriction_to[i]);
    restriction.via = {finite(DatumGetFloat8(taken.restriction_x[i]), "x of a turn restriction"),
                       finite(DatumGetFloat8(taken.restriction_y[i]), "y of a turn restriction"),
                       0};
    restriction.only = word_of<bool>(text_of(taken.restriction_kind[i]),
                                     "kind of a turn restriction", {{"no", false}, {"only", true}});
    using OfTurn = std::optional<Turn>;
    restriction.turn =
        word_of<OfTurn>(text_of(taken.restriction_turn[i]), "turn of a turn restriction",
                        {{"", OfTurn()},
                         {turn_name(Turn::through), OfTurn(Turn::through)},
                         {turn_name(Turn::left), OfTurn(Turn::left)},
                         {turn_name(Turn::right), OfTurn(Turn::right)},
                         {turn_name(Turn::u_turn), OfTurn(Turn::u_turn)}});
    restrictions.push_back(restriction);
  }
  return restrictions;
}

InterconnectionSettings interconnection_settings_of(const Taken& taken) {
  InterconnectionSettings settings;
  settings.u_turn = taken.u_turn;
  settings.rule =
      word_of<TrajectoryRule>(taken.trajectory, "trajectory",
                              {{"bezier", TrajectoryRule::bezier}, {"arcs", TrajectoryRule::arcs}});
  settings.tolerance =
      in_range(taken.trajectory_tolerance, 1e-3, 1000, "setting trajectory_tolerance");
  settings.least_radius = in_range(taken.trajectory_radius, 0, 1000, "setting trajectory_radius");
  settings.node_tolerance = taken.tolerance;
  return settings;
}

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

void append_network(const Network& network, Form with_z, Form flat, Rows& rows) {
  for (std::size_t i = 0; i < network.nodes.size(); ++i) {
    Row& row = add(rows, "node");
    row.row_index = static_cast<int>(i);
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

void append_streets(const Streets& streets, Form with_z, Form flat, Rows& rows) {
  for (const SectionLimit& limit : streets.limits) {
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

Rows rows_of(const Taken& taken) {
  bool has_z = false;
  const std::vector<StreetAxis> axes = axes_of(taken, &has_z);
  const Streets result = streets(axes, settings_of(taken));
  Rows rows;
  const Form with_z{taken.srid, has_z}, flat{taken.srid, false};
  append_network(result.network, with_z, flat, rows);
  append_streets(result, with_z, flat, rows);
  const Lanes traffic =
      lanes(result, lanes_of(taken), overrides_of(taken), lane_settings_of(taken));
  append_lanes(traffic, flat, rows);
  append_interconnections(interconnections(result, axes, traffic.lanes, restrictions_of(taken),
                                           interconnection_settings_of(taken)),
                          flat, rows);
  return rows;
}

// Arrays that belong together: one element each for every axis, override and the like.
struct Columns {
  FunctionCallInfo fcinfo;
  const char* of;
  int count = -1;  // of the first one read
};

// One column of a list: an array argument as long as the others, without NULL.
Datum* column(Columns* list, int argument, const char* name, Oid type) {
  FunctionCallInfo fcinfo = list->fcinfo;
  int16 size;
  bool by_value;
  char align;
  get_typlenbyvalalign(type, &size, &by_value, &align);
  Datum* datums;
  bool* nulls;
  int found;
  deconstruct_array(PG_GETARG_ARRAYTYPE_P(argument), type, size, by_value, align, &datums, &nulls,
                    &found);
  for (int i = 0; i < found; ++i)
    if (nulls[i])
      ereport(ERROR, (errcode(ERRCODE_NULL_VALUE_NOT_ALLOWED),
                      errmsg("%s is NULL at position %d of the %s", name, i + 1, list->of)));
  if (list->count >= 0 && found != list->count)
    ereport(ERROR, (errcode(ERRCODE_ARRAY_SUBSCRIPT_ERROR),
                    errmsg("%s has %d elements for %d %s", name, found, list->count, list->of)));
  list->count = found;
  return datums;
}

void take(FunctionCallInfo fcinfo, Taken* taken) {
  Columns axes{fcinfo, "axes"}, transitions{fcinfo, "transitions"};
  Columns overrides{fcinfo, "lane overrides"};
  Columns restrictions{fcinfo, "turn restrictions"};
  taken->axis_id = column(&axes, 0, "axis_id", INT8OID);
  taken->geom = column(&axes, 1, "geom", BYTEAOID);
  taken->width = column(&axes, 2, "width", FLOAT8OID);
  taken->width_end = column(&axes, 3, "width_end", FLOAT8OID);
  taken->radius = column(&axes, 4, "radius", FLOAT8OID);
  taken->importance = column(&axes, 5, "importance", INT4OID);
  taken->level = column(&axes, 6, "level", INT4OID);
  taken->count = axes.count;
  for (int i = 0; i < taken->count; ++i)
    taken->geom[i] = PointerGetDatum(PG_DETOAST_DATUM_PACKED(taken->geom[i]));
  taken->srid = PG_GETARG_INT32(7);
  taken->tolerance = PG_GETARG_FLOAT8(8);
  taken->crossing = text_to_cstring(PG_GETARG_TEXT_PP(9));
  taken->max_arc_distance = PG_GETARG_FLOAT8(10);
  taken->radius_minimal = PG_GETARG_FLOAT8(11);
  taken->transition_length = PG_GETARG_FLOAT8(12);
  taken->transition_kind = text_to_cstring(PG_GETARG_TEXT_PP(13));
  taken->radius_rule = text_to_cstring(PG_GETARG_TEXT_PP(14));
  taken->round_dead_ends = PG_GETARG_BOOL(15);
  taken->max_hole_area = PG_GETARG_FLOAT8(16);
  taken->reach = PG_GETARG_FLOAT8(17);
  taken->short_axis = text_to_cstring(PG_GETARG_TEXT_PP(18));
  taken->transition_axis = column(&transitions, 19, "transition_axis", INT8OID);
  taken->transition_which = column(&transitions, 20, "transition_which", TEXTOID);
  taken->transition_kind_of = column(&transitions, 21, "transition_kind_of", TEXTOID);
  taken->transition_length_of = column(&transitions, 22, "transition_length_of", FLOAT8OID);
  taken->transition_count = transitions.count;
  taken->lanes_forward = column(&axes, 23, "lanes_forward", INT4OID);
  taken->lanes_backward = column(&axes, 24, "lanes_backward", INT4OID);
  taken->kind_forward = column(&axes, 25, "kind_forward", TEXTOID);
  taken->kind_backward = column(&axes, 26, "kind_backward", TEXTOID);
  taken->lane_width_forward = column(&axes, 27, "lane_width_forward", TEXTOID);
  taken->lane_width_backward = column(&axes, 28, "lane_width_backward", TEXTOID);
  taken->turn_forward = column(&axes, 29, "turn_forward", TEXTOID);
  taken->turn_backward = column(&axes, 30, "turn_backward", TEXTOID);
  taken->override_axis = column(&overrides, 31, "override_axis", INT8OID);
  taken->override_abscissa = column(&overrides, 32, "override_abscissa", FLOAT8OID);
  taken->override_ordinality = column(&overrides, 33, "override_ordinality", INT4OID);
  taken->override_direction = column(&overrides, 34, "override_direction", TEXTOID);
  taken->override_width = column(&overrides, 35, "override_width", FLOAT8OID);
  taken->override_count = overrides.count;
  taken->lane_order = text_to_cstring(PG_GETARG_TEXT_PP(36));
  taken->driving_side = text_to_cstring(PG_GETARG_TEXT_PP(37));
  taken->lane_width_minimal = PG_GETARG_FLOAT8(38);
  taken->cycle_lane_width = PG_GETARG_FLOAT8(39);
  taken->parking_lane_width = PG_GETARG_FLOAT8(40);
  taken->edge_lines = PG_GETARG_BOOL(41);
  taken->speed = column(&axes, 42, "speed", FLOAT8OID);
  taken->restriction_from = column(&restrictions, 43, "restriction_from", INT8OID);
  taken->restriction_to = column(&restrictions, 44, "restriction_to", INT8OID);
  taken->restriction_x = column(&restrictions, 45, "restriction_x", FLOAT8OID);
  taken->restriction_y = column(&restrictions, 46, "restriction_y", FLOAT8OID);
  taken->restriction_kind = column(&restrictions, 47, "restriction_kind", TEXTOID);
  taken->restriction_turn = column(&restrictions, 48, "restriction_turn", TEXTOID);
  taken->restriction_count = restrictions.count;
  taken->u_turn = PG_GETARG_BOOL(49);
  taken->trajectory = text_to_cstring(PG_GETARG_TEXT_PP(50));
  taken->trajectory_tolerance = PG_GETARG_FLOAT8(51);
  taken->trajectory_radius = PG_GETARG_FLOAT8(52);
}

void give(const Rows& rows, ReturnSetInfo* result) {
  MemoryContext per_row =
      AllocSetContextCreate(CurrentMemoryContext, "streetgen row", ALLOCSET_DEFAULT_SIZES);
  for (const Row& row : rows) {
    MemoryContext outer = MemoryContextSwitchTo(per_row);
    Datum values[22];
    bool nulls[22] = {false};
    values[0] = CStringGetTextDatum(row.relation);
    values[1] = Int32GetDatum(row.row_index);
    values[2] = Int64GetDatum(row.axis_id);
    const int indices[4] = {row.node_a, row.node_b, row.edge_a, row.edge_b};
    for (int i = 0; i < 4; ++i) {
      values[3 + i] = Int32GetDatum(indices[i]);
      nulls[3 + i] = indices[i] < 0;
    }
    values[7] = BoolGetDatum(row.start_a);
    values[8] = BoolGetDatum(row.start_b);
    values[9] = Int32GetDatum(row.level);
    values[10] = Float8GetDatum(row.measure_1);
    values[11] = Float8GetDatum(row.measure_2);
    nulls[12] = row.geom_1.empty();
    if (!nulls[12]) values[12] = bytes_datum(row.geom_1);
    nulls[13] = row.geom_2.empty();
    if (!nulls[13]) values[13] = bytes_datum(row.geom_2);
    const int anchors = static_cast<int>(row.anchor_axis.size());
    auto* of_axes = static_cast<Datum*>(palloc(sizeof(Datum) * (anchors + 1)));
    auto* of_abscissas = static_cast<Datum*>(palloc(sizeof(Datum) * (anchors + 1)));
    for (int i = 0; i < anchors; ++i) {
      of_axes[i] = Int64GetDatum(row.anchor_axis[i]);
      if (!row.anchor_abscissa.empty()) of_abscissas[i] = Float8GetDatum(row.anchor_abscissa[i]);
    }
    values[14] = PointerGetDatum(construct_array(of_axes, anchors, INT8OID, 8, true, 'd'));
    values[15] = PointerGetDatum(construct_array(
        of_abscissas, row.anchor_abscissa.empty() ? 0 : anchors, FLOAT8OID, 8, true, 'd'));
    values[16] = CStringGetTextDatum(row.method);
    values[17] = Int32GetDatum(row.lane_position);
    nulls[17] = row.lane_position < 0;
    values[18] = Int32GetDatum(row.ordinality);
    nulls[18] = row.ordinality < 0;
    const std::string* words[3] = {&row.side, &row.kind, &row.turn};
    for (int i = 0; i < 3; ++i) {
      nulls[19 + i] = words[i]->empty();
      if (!nulls[19 + i]) values[19 + i] = CStringGetTextDatum(words[i]->c_str());
    }
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
    MemoryContextSwitchTo(outer);
    MemoryContextReset(per_row);
  }
  MemoryContextDelete(per_row);
}

}  // namespace
}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_streets) {
  using namespace streetgen::pg;
  Taken taken;
  take(fcinfo, &taken);
  InitMaterializedSRF(fcinfo, 0);
  Slot<Rows>* slot = make_slot<Rows>(CurrentMemoryContext);
  const Outcome outcome = compute([&] { slot->value = new Rows(rows_of(taken)); });
  report(outcome);
  give(*slot->value, reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo));
  PG_RETURN_NULL();
}
