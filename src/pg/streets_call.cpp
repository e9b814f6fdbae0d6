#include "streets_call.hpp"

extern "C" {
#include <catalog/pg_type.h>
#include <utils/array.h>
#include <utils/builtins.h>
#include <utils/lsyscache.h>
}

namespace streetgen::pg {

namespace {

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

// One of geometries.
Datum* bytes_column(Columns* list, int argument, const char* name) {
  Datum* datums = column(list, argument, name, BYTEAOID);
  for (int i = 0; i < list->count; ++i)
    datums[i] = PointerGetDatum(PG_DETOAST_DATUM_PACKED(datums[i]));
  return datums;
}

}  // namespace

void take(FunctionCallInfo fcinfo, StreetsCall* call) {
  Columns axes{fcinfo, "axes"}, transitions{fcinfo, "transitions"};
  Columns overrides{fcinfo, "lane overrides"};
  Columns restrictions{fcinfo, "turn restrictions"};
  Columns former_edges{fcinfo, "former edges"}, former_places{fcinfo, "former places"};
  Columns limits{fcinfo, "section limit overrides"}, corners{fcinfo, "corner overrides"};
  call->axis_id = column(&axes, 0, "axis_id", INT8OID);
  call->geom = bytes_column(&axes, 1, "geom");
  call->width = column(&axes, 2, "width", FLOAT8OID);
  call->width_end = column(&axes, 3, "width_end", FLOAT8OID);
  call->radius = column(&axes, 4, "radius", FLOAT8OID);
  call->importance = column(&axes, 5, "importance", INT4OID);
  call->level = column(&axes, 6, "level", INT4OID);
  call->count = axes.count;
  call->srid = PG_GETARG_INT32(7);
  call->tolerance = PG_GETARG_FLOAT8(8);
  call->crossing = text_to_cstring(PG_GETARG_TEXT_PP(9));
  call->max_arc_distance = PG_GETARG_FLOAT8(10);
  call->radius_minimal = PG_GETARG_FLOAT8(11);
  call->transition_length = PG_GETARG_FLOAT8(12);
  call->transition_kind = text_to_cstring(PG_GETARG_TEXT_PP(13));
  call->radius_rule = text_to_cstring(PG_GETARG_TEXT_PP(14));
  call->round_dead_ends = PG_GETARG_BOOL(15);
  call->max_hole_area = PG_GETARG_FLOAT8(16);
  call->reach = PG_GETARG_FLOAT8(17);
  call->short_axis = text_to_cstring(PG_GETARG_TEXT_PP(18));
  call->transition_axis = column(&transitions, 19, "transition_axis", INT8OID);
  call->transition_which = column(&transitions, 20, "transition_which", TEXTOID);
  call->transition_kind_of = column(&transitions, 21, "transition_kind_of", TEXTOID);
  call->transition_length_of = column(&transitions, 22, "transition_length_of", FLOAT8OID);
  call->transition_count = transitions.count;
  call->lanes_forward = column(&axes, 23, "lanes_forward", INT4OID);
  call->lanes_backward = column(&axes, 24, "lanes_backward", INT4OID);
  call->kind_forward = column(&axes, 25, "kind_forward", TEXTOID);
  call->kind_backward = column(&axes, 26, "kind_backward", TEXTOID);
  call->lane_width_forward = column(&axes, 27, "lane_width_forward", TEXTOID);
  call->lane_width_backward = column(&axes, 28, "lane_width_backward", TEXTOID);
  call->turn_forward = column(&axes, 29, "turn_forward", TEXTOID);
  call->turn_backward = column(&axes, 30, "turn_backward", TEXTOID);
  call->override_axis = column(&overrides, 31, "override_axis", INT8OID);
  call->override_abscissa = column(&overrides, 32, "override_abscissa", FLOAT8OID);
  call->override_ordinality = column(&overrides, 33, "override_ordinality", INT4OID);
  call->override_direction = column(&overrides, 34, "override_direction", TEXTOID);
  call->override_width = column(&overrides, 35, "override_width", FLOAT8OID);
  call->override_count = overrides.count;
  call->lane_order = text_to_cstring(PG_GETARG_TEXT_PP(36));
  call->driving_side = text_to_cstring(PG_GETARG_TEXT_PP(37));
  call->lane_width_minimal = PG_GETARG_FLOAT8(38);
  call->cycle_lane_width = PG_GETARG_FLOAT8(39);
  call->parking_lane_width = PG_GETARG_FLOAT8(40);
  call->edge_lines = PG_GETARG_BOOL(41);
  call->speed = column(&axes, 42, "speed", FLOAT8OID);
  call->restriction_from = column(&restrictions, 43, "restriction_from", INT8OID);
  call->restriction_to = column(&restrictions, 44, "restriction_to", INT8OID);
  call->restriction_x = column(&restrictions, 45, "restriction_x", FLOAT8OID);
  call->restriction_y = column(&restrictions, 46, "restriction_y", FLOAT8OID);
  call->restriction_kind = column(&restrictions, 47, "restriction_kind", TEXTOID);
  call->restriction_turn = column(&restrictions, 48, "restriction_turn", TEXTOID);
  call->restriction_count = restrictions.count;
  call->u_turn = PG_GETARG_BOOL(49);
  call->trajectory = text_to_cstring(PG_GETARG_TEXT_PP(50));
  call->trajectory_tolerance = PG_GETARG_FLOAT8(51);
  call->trajectory_radius = PG_GETARG_FLOAT8(52);
  call->changed = column(&axes, 53, "changed", BOOLOID);
  call->beside = column(&axes, 54, "beside", BOOLOID);
  call->former_axis = column(&former_edges, 55, "former_axis", INT8OID);
  call->former_geom = bytes_column(&former_edges, 56, "former_geom");
  for (int i = 0; i < 4; ++i)
    call->former_limits[i] = column(&former_edges, 57 + i, "former_limits", FLOAT8OID);
  call->former_edge_count = former_edges.count;
  call->former_x = column(&former_places, 61, "former_x", FLOAT8OID);
  call->former_y = column(&former_places, 62, "former_y", FLOAT8OID);
  call->former_met = column(&former_places, 63, "former_met", BOOLOID);
  call->former_place_count = former_places.count;
  call->override_line = bytes_column(&overrides, 64, "override_line");
  call->limit_axis = column(&limits, 65, "limit_axis", INT8OID);
  call->limit_abscissa = column(&limits, 66, "limit_abscissa", FLOAT8OID);
  call->limit_which = column(&limits, 67, "limit_which", TEXTOID);
  call->limit_count = limits.count;
  call->corner_a = column(&corners, 68, "corner_a", INT8OID);
  call->corner_b = column(&corners, 69, "corner_b", INT8OID);
  call->corner_x = column(&corners, 70, "corner_x", FLOAT8OID);
  call->corner_y = column(&corners, 71, "corner_y", FLOAT8OID);
  call->corner_radius = column(&corners, 72, "corner_radius", FLOAT8OID);
  call->corner_count = corners.count;
  call->outer = column(&axes, 73, "outer", BOOLOID);
}

}  // namespace streetgen::pg
