#include "model/streets_call.hpp"

#include "frame/composite_rows.hpp"

extern "C" {
#include <catalog/pg_type.h>
#include <utils/array.h>
#include <utils/builtins.h>
#include <utils/jsonb.h>
}

namespace streetgen::pg {

namespace {

// A JSON object of words; what is no word there has no value.
void take_settings(FunctionCallInfo fcinfo, int argument, StreetsCall* call) {
  auto& settings = call->settings;
  settings.count = 0;
  if (PG_ARGISNULL(argument)) return;
  Jsonb* object = PG_GETARG_JSONB_P(argument);
  if (!JB_ROOT_IS_OBJECT(object))
    ereport(ERROR,
            (errcode(ERRCODE_INVALID_PARAMETER_VALUE), errmsg("settings are no JSON object")));
  const Size bytes = sizeof(char*) * (JB_ROOT_COUNT(object) + 1);
  settings.names = static_cast<const char**>(palloc(bytes));
  settings.values = static_cast<const char**>(palloc(bytes));
  JsonbIterator* iterator = JsonbIteratorInit(&object->root);
  JsonbValue item;
  JsonbIteratorToken token;
  while ((token = JsonbIteratorNext(&iterator, &item, true)) != WJB_DONE) {
    const bool word = item.type == jbvString;
    if (token == WJB_KEY)
      settings.names[settings.count] = pnstrdup(item.val.string.val, item.val.string.len);
    else if (token == WJB_VALUE)
      settings.values[settings.count++] =
          word ? pnstrdup(item.val.string.val, item.val.string.len) : nullptr;
  }
}

void take_subjects(FunctionCallInfo fcinfo, int argument, StreetsCall* call) {
  Datum* words;
  bool* nulls;
  deconstruct_array(PG_GETARG_ARRAYTYPE_P(argument), TEXTOID, -1, false, TYPALIGN_INT, &words,
                    &nulls, &call->subjects.count);
  call->subjects.words =
      static_cast<const char**>(palloc(sizeof(char*) * (call->subjects.count + 1)));
  for (int i = 0; i < call->subjects.count; ++i) {
    if (nulls[i])
      ereport(ERROR, (errcode(ERRCODE_NULL_VALUE_NOT_ALLOWED), errmsg("a subject is NULL")));
    call->subjects.words[i] = TextDatumGetCString(words[i]);
  }
}

}  // namespace

void take_network(FunctionCallInfo fcinfo, StreetsCall* call) {
  call->srid = PG_GETARG_INT32(0);
  take_settings(fcinfo, 1, call);

  const Rows axes = rows(fcinfo, 2, "axes");
  call->axes = {axes.count,
                column(axes, "axis_id", INT8OID),
                column(axes, "geom", BYTEAOID),
                column(axes, "level", INT4OID),
                column(axes, "width", FLOAT8OID),
                column(axes, "width_end", FLOAT8OID),
                column(axes, "roadway_offset", FLOAT8OID),
                column(axes, "radius", FLOAT8OID),
                column(axes, "importance", INT4OID),
                column(axes, "speed", FLOAT8OID),
                column(axes, "lanes_forward", INT4OID),
                column(axes, "lanes_backward", INT4OID),
                column(axes, "lanes_both", INT4OID),
                column_or_null(axes, "kind_forward", TEXTOID),
                column_or_null(axes, "kind_backward", TEXTOID),
                column_or_null(axes, "lane_width_forward", TEXTOID),
                column_or_null(axes, "lane_width_backward", TEXTOID),
                column_or_null(axes, "lane_width_maximal", FLOAT8OID),
                column_or_null(axes, "turn_forward", TEXTOID),
                column_or_null(axes, "turn_backward", TEXTOID),
                column_or_null(axes, "access", TEXTOID),
                column(axes, "on_ring", BOOLOID),
                column(axes, "street", INT8OID),
                column(axes, "changed", BOOLOID),
                column(axes, "outer_axis", BOOLOID),
                column_or_null(axes, "area", BYTEAOID)};
}

void take(FunctionCallInfo fcinfo, StreetsCall* call) {
  take_network(fcinfo, call);

  const Rows transitions = rows(fcinfo, 3, "transitions");
  call->transitions = {transitions.count, column(transitions, "axis_id", INT8OID),
                       column(transitions, "which", TEXTOID), column(transitions, "kind", TEXTOID),
                       column_or_null(transitions, "length", FLOAT8OID)};

  const Rows limits = rows(fcinfo, 4, "section limits");
  call->limits = {limits.count, column(limits, "axis_id", INT8OID),
                  column(limits, "abscissa", FLOAT8OID), column(limits, "which", TEXTOID)};

  const Rows corners = rows(fcinfo, 5, "corners");
  call->corners = {corners.count,
                   column(corners, "axis_a", INT8OID),
                   column(corners, "axis_b", INT8OID),
                   column(corners, "x", FLOAT8OID),
                   column(corners, "y", FLOAT8OID),
                   column(corners, "radius", FLOAT8OID)};

  const Rows lanes = rows(fcinfo, 6, "lanes");
  call->lanes = {lanes.count,
                 column(lanes, "axis_id", INT8OID),
                 column(lanes, "abscissa", FLOAT8OID),
                 column(lanes, "ordinality", INT4OID),
                 column_or_null(lanes, "along_axis", BOOLOID),
                 column_or_null(lanes, "both_ways", BOOLOID),
                 column_or_null(lanes, "width", FLOAT8OID),
                 column_or_null(lanes, "line", BYTEAOID)};

  const Rows restrictions = rows(fcinfo, 7, "turn restrictions");
  call->restrictions = {restrictions.count,
                        column(restrictions, "from_axis", INT8OID),
                        column(restrictions, "to_axis", INT8OID),
                        column(restrictions, "x", FLOAT8OID),
                        column(restrictions, "y", FLOAT8OID),
                        column(restrictions, "kind", TEXTOID),
                        column_or_null(restrictions, "turn", TEXTOID),
                        column_or_null(restrictions, "except_kinds", TEXTOID)};

  const Rows edges = rows(fcinfo, 8, "former edges");
  call->former_edges = {edges.count,
                        column(edges, "axis_id", INT8OID),
                        column(edges, "start_abscissa", FLOAT8OID),
                        column(edges, "end_abscissa", FLOAT8OID),
                        column(edges, "geom", BYTEAOID),
                        column(edges, "wanted_start", FLOAT8OID),
                        column(edges, "start", FLOAT8OID),
                        column(edges, "border_start", BYTEAOID),
                        column(edges, "wanted_end", FLOAT8OID),
                        column(edges, "end", FLOAT8OID),
                        column(edges, "border_end", BYTEAOID),
                        column(edges, "surface", BYTEAOID),
                        column(edges, "contested", BOOLOID),
                        column(edges, "level", INT4OID),
                        column(edges, "borders", BYTEAOID),
                        column(edges, "beside_left", TEXTOID),
                        column(edges, "beside_right", TEXTOID),
                        column(edges, "median_left", BYTEAOID),
                        column(edges, "median_right", BYTEAOID)};

  const Rows nodes = rows(fcinfo, 9, "former nodes");
  call->former_nodes = {nodes.count,
                        column(nodes, "x", FLOAT8OID),
                        column(nodes, "y", FLOAT8OID),
                        column(nodes, "surface", BYTEAOID),
                        column(nodes, "contested", BOOLOID),
                        column(nodes, "level", INT4OID)};
  call->may_spread = PG_ARGISNULL(10) || PG_GETARG_BOOL(10);
  take_subjects(fcinfo, 11, call);

  const Rows neighbours = rows(fcinfo, 12, "neighbours");
  call->neighbours = {neighbours.count,
                      column(neighbours, "x", FLOAT8OID),
                      column(neighbours, "y", FLOAT8OID),
                      column_or_null(neighbours, "x_end", FLOAT8OID),
                      column_or_null(neighbours, "y_end", FLOAT8OID),
                      column(neighbours, "surface", BYTEAOID),
                      column(neighbours, "level", INT4OID),
                      !PG_ARGISNULL(12)};

  call->controls = take_controls(fcinfo, 13);
  const Rows overpasses = rows(fcinfo, 14, "overpasses");
  call->overpasses = {overpasses.count,
                      column(overpasses, "axis_above", INT8OID),
                      column(overpasses, "axis_below", INT8OID),
                      column(overpasses, "x", FLOAT8OID),
                      column(overpasses, "y", FLOAT8OID),
                      column_or_null(overpasses, "clearance", FLOAT8OID)};
  const Rows bends = rows(fcinfo, 15, "bends");
  call->bends = {bends.count, column(bends, "axis_id", INT8OID),
                 column(bends, "abscissa", FLOAT8OID), column(bends, "radius", FLOAT8OID)};
  const Rows circulations = rows(fcinfo, 16, "circulations");
  call->circulations = {circulations.count, column(circulations, "axis_id", INT8OID),
                        column(circulations, "abscissa", FLOAT8OID),
                        column(circulations, "along_axis", BOOLOID),
                        column(circulations, "turned", BOOLOID)};
  const Rows ramp_axes = rows(fcinfo, 17, "ramp axes");
  call->ramp_axes = {ramp_axes.count, column(ramp_axes, "axis_id", INT8OID),
                     column(ramp_axes, "part", TEXTOID), column(ramp_axes, "counted", BOOLOID)};
  const Rows ramps = rows(fcinfo, 18, "ramp overrides");
  call->ramps = {ramps.count, column(ramps, "axis_id", INT8OID),
                 column(ramps, "abscissa", FLOAT8OID), column_or_null(ramps, "tangent", FLOAT8OID),
                 column_or_null(ramps, "length", FLOAT8OID)};
  call->paint = take_paint(fcinfo, 19, 20, 21);
  const Rows marked = rows(fcinfo, 22, "axes marked before");
  call->marked_before = {marked.count, column(marked, "axis_id", INT8OID)};
}

}  // namespace streetgen::pg
