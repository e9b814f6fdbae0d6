// streetgen._streets: the whole pipeline over a set of axes, one row per result.
#include "streetgen/streets.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "border.hpp"
#include "wkb.hpp"

extern "C" {
#include <catalog/pg_type.h>
#include <funcapi.h>
#include <utils/array.h>
#include <utils/builtins.h>
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
};
using Rows = std::vector<Row>;

// What the take step found: PostgreSQL's memory, plain pointers.
struct Taken {
  int count;
  Datum *axis_id, *geom, *width, *width_end, *radius, *importance, *level;
  int srid;
  double tolerance, max_arc_distance, radius_minimal, transition_length, max_hole_area, reach;
  const char *crossing, *transition_kind, *radius_rule;
  bool round_dead_ends, follow_first;
};

double checked(double value, double low, double high, const std::string& what,
               std::int64_t axis_id) {
  if (!(value >= low && value <= high))
    throw Error(ErrorKind::invalid_input, what + " of axis " + std::to_string(axis_id) + " is " +
                                              std::to_string(value) + ", expected " +
                                              std::to_string(low) + " to " + std::to_string(high));
  return value;
}

std::vector<StreetAxis> axes_of(const Taken& taken, bool* has_z) {
  std::vector<StreetAxis> axes;
  for (int i = 0; i < taken.count; ++i) {
    StreetAxis axis;
    axis.axis_id = DatumGetInt64(taken.axis_id[i]);
    const auto* wkb = reinterpret_cast<const struct varlena*>(DatumGetPointer(taken.geom[i]));
    const ReadLine read = read_line({VARDATA_ANY(wkb), VARSIZE_ANY_EXHDR(wkb)},
                                    "the geometry of axis " + std::to_string(axis.axis_id));
    if (read.srid != taken.srid)
      throw Error(ErrorKind::invalid_input, "the geometry of axis " + std::to_string(axis.axis_id) +
                                                " has SRID " + std::to_string(read.srid) +
                                                ", expected " + std::to_string(taken.srid));
    *has_z = *has_z || read.has_z;
    axis.line = read.line;
    axis.width = checked(DatumGetFloat8(taken.width[i]), 1e-3, 200, "width", axis.axis_id);
    axis.width_end =
        checked(DatumGetFloat8(taken.width_end[i]), 1e-3, 200, "width_end", axis.axis_id);
    axis.radius = checked(DatumGetFloat8(taken.radius[i]), 0, 1000, "radius", axis.axis_id);
    axis.importance = DatumGetInt32(taken.importance[i]);
    axis.level = DatumGetInt32(taken.level[i]);
    axes.push_back(std::move(axis));
  }
  return axes;
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

void append_network(const Network& network, Form with_z, Form flat, Rows& rows) {
  for (std::size_t i = 0; i < network.nodes.size(); ++i) {
    Row row;
    row.relation = "node";
    row.row_index = static_cast<int>(i);
    row.geom_1 = write_point(network.nodes[i].point, with_z);
    for (const NodeAnchor& anchor : network.nodes[i].anchors) {
      row.anchor_axis.push_back(anchor.axis_id);
      row.anchor_abscissa.push_back(anchor.abscissa);
    }
    rows.push_back(std::move(row));
  }
  for (std::size_t i = 0; i < network.edges.size(); ++i) {
    const Edge& edge = network.edges[i];
    Row row;
    row.relation = "edge";
    row.row_index = static_cast<int>(i);
    row.axis_id = edge.axis_id;
    row.node_a = edge.from_node;
    row.node_b = edge.to_node;
    row.level = edge.level;
    row.measure_1 = edge.start_abscissa;
    row.measure_2 = edge.end_abscissa;
    row.geom_1 = write_line(edge.line, with_z);
    rows.push_back(std::move(row));
  }
  for (const NetworkReport& report : network.reports) {
    Row row;
    row.relation = "report";
    row.axis_id = report.axis_a;
    row.anchor_axis = {report.axis_b};
    row.measure_1 = report.measure;
    row.geom_1 = write_point(report.point, flat);
    row.method = issue_name(report.issue);
    rows.push_back(std::move(row));
  }
}

void append_streets(const Streets& streets, Form with_z, Form flat, Rows& rows) {
  for (const SectionLimit& limit : streets.limits) {
    Row row;
    row.relation = "section_limit";
    row.edge_a = limit.edge;
    row.start_a = limit.at_start;
    row.measure_1 = limit.wanted_abscissa;
    row.measure_2 = limit.abscissa;
    row.geom_1 = write_point(limit.point, with_z);
    row.geom_2 = write_line(limit.border_line, flat);
    row.method = method_name(limit.method);
    rows.push_back(std::move(row));
  }
  for (const Corner& corner : streets.corners) {
    Row row;
    row.relation = "corner";
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
    rows.push_back(std::move(row));
  }
  for (const Section& section : streets.sections) {
    Row row;
    row.relation = "section";
    row.edge_a = section.edge;
    row.level = streets.network.edges[section.edge].level;
    row.measure_1 = section.contested_area;
    row.geom_1 = write_surface(section.surface, flat);
    row.method = method_name(section.method);
    rows.push_back(std::move(row));
  }
  for (const Intersection& intersection : streets.intersections) {
    Row row;
    row.relation = "intersection";
    row.node_a = intersection.node;
    row.level = intersection.level;
    row.measure_1 = intersection.contested_area;
    row.geom_1 = write_surface(intersection.surface, flat);
    row.method = method_name(intersection.method);
    rows.push_back(std::move(row));
  }
}

Rows rows_of(const Taken& taken) {
  bool has_z = false;
  const std::vector<StreetAxis> axes = axes_of(taken, &has_z);
  StreetSettings settings;
  settings.tolerance = taken.tolerance;
  settings.crossing = std::string(taken.crossing) == "split" ? Crossing::split : Crossing::over;
  settings.max_arc_distance = taken.max_arc_distance;
  settings.radius_minimal = taken.radius_minimal;
  settings.transition_length = taken.transition_length;
  settings.transition_kind = taken.transition_kind;
  settings.radius_rule = taken.radius_rule;
  settings.round_dead_ends = taken.round_dead_ends;
  settings.max_hole_area = taken.max_hole_area;
  settings.reach = taken.reach;
  settings.follow_first = taken.follow_first;
  const Streets result = streets(axes, settings);
  Rows rows;
  const Form with_z{taken.srid, has_z}, flat{taken.srid, false};
  append_network(result.network, with_z, flat, rows);
  append_streets(result, with_z, flat, rows);
  return rows;
}

Datum* elements(FunctionCallInfo fcinfo, int argument, Oid type, int16 size, bool by_value,
                char align, int expected, int* count) {
  ArrayType* array = PG_GETARG_ARRAYTYPE_P(argument);
  Datum* datums;
  bool* nulls;
  deconstruct_array(array, type, size, by_value, align, &datums, &nulls, count);
  for (int i = 0; i < *count; ++i)
    if (nulls[i])
      ereport(ERROR, (errcode(ERRCODE_NULL_VALUE_NOT_ALLOWED),
                      errmsg("array number %d has a NULL at position %d", argument + 1, i + 1)));
  if (expected >= 0 && *count != expected)
    ereport(ERROR, (errcode(ERRCODE_ARRAY_SUBSCRIPT_ERROR),
                    errmsg("array number %d has %d elements, expected %d", argument + 1, *count,
                           expected)));
  return datums;
}

void take(FunctionCallInfo fcinfo, Taken* taken) {
  int n;
  taken->axis_id = elements(fcinfo, 0, INT8OID, 8, true, 'd', -1, &taken->count);
  taken->geom = elements(fcinfo, 1, BYTEAOID, -1, false, 'i', taken->count, &n);
  taken->width = elements(fcinfo, 2, FLOAT8OID, 8, true, 'd', taken->count, &n);
  taken->width_end = elements(fcinfo, 3, FLOAT8OID, 8, true, 'd', taken->count, &n);
  taken->radius = elements(fcinfo, 4, FLOAT8OID, 8, true, 'd', taken->count, &n);
  taken->importance = elements(fcinfo, 5, INT4OID, 4, true, 'i', taken->count, &n);
  taken->level = elements(fcinfo, 6, INT4OID, 4, true, 'i', taken->count, &n);
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
  taken->follow_first = PG_GETARG_BOOL(18);
}

Datum bytes_datum(const std::string& bytes) {
  auto* out = static_cast<bytea*>(palloc(VARHDRSZ + bytes.size()));
  SET_VARSIZE(out, VARHDRSZ + bytes.size());
  memcpy(VARDATA(out), bytes.data(), bytes.size());
  return PointerGetDatum(out);
}

void give(const Rows& rows, ReturnSetInfo* result) {
  MemoryContext per_row =
      AllocSetContextCreate(CurrentMemoryContext, "streetgen row", ALLOCSET_DEFAULT_SIZES);
  for (const Row& row : rows) {
    MemoryContext outer = MemoryContextSwitchTo(per_row);
    Datum values[17];
    bool nulls[17] = {false};
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
