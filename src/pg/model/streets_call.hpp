// The arguments of streetgen._streets: PostgreSQL's memory, plain pointers.
#pragma once

#include "frame/composite_rows.hpp"
#include "value/control_rows.hpp"
#include "value/paint_rows.hpp"

namespace streetgen::pg {

struct StreetsCall {
  int srid;
  struct {
    int count;
    const char **names, **values;  // NULL: no value
  } settings;
  struct {
    int count;
    Column axis_id, geom, level, width, width_end, roadway_offset, radius, importance, speed;
    Column lanes_forward, lanes_backward, lanes_both, kind_forward, kind_backward;
    Column lane_width_forward, lane_width_backward, lane_width_maximal;
    Column turn_forward, turn_backward, access;
    Column on_ring, street, changed, outer_axis, area;
  } axes;
  struct {
    int count;
    Column axis_id, which, kind, length;
  } transitions;
  struct {
    int count;
    Column axis_id, abscissa, which;
  } limits;
  struct {
    int count;
    Column axis_a, axis_b, x, y, radius;
  } corners;
  struct {
    int count;
    Column axis_id, abscissa, ordinality, along_axis, both_ways, width, line;
  } lanes;
  struct {
    int count;
    Column from_axis, to_axis, x, y, kind, turn, except_kinds;
  } restrictions;
  struct {
    int count;
    Column axis_id, start_abscissa, end_abscissa, geom;
    Column wanted_start, start, border_start, wanted_end, end, border_end, surface, contested,
        level, borders, beside_left, beside_right, median_left, median_right;
  } former_edges;
  struct {
    int count;
    Column x, y, surface, contested, level;
  } former_nodes;
  struct {
    int count;
    Column x, y, x_end, y_end, surface, level;
    bool known;
  } neighbours;
  struct {
    int count;
    Column axis_id, abscissa, radius;
  } bends;
  ControlRows controls;
  PaintRows paint;
  struct {
    int count;
    Column axis_above, axis_below, x, y, clearance;
  } overpasses;
  struct {
    int count;
    Column axis_id, abscissa, along_axis, turned;
  } circulations;
  struct {
    int count;
    Column axis_id, part, counted;
  } ramp_axes;
  struct {
    int count;
    Column axis_id, abscissa, tangent, length;
  } ramps;
  struct {
    int count;
    Column axis_id;
  } marked_before;
  bool may_spread;
  struct {
    int count;
    const char** words;
  } subjects;
};

// The reference, settings and axes alone.  Raises where a row lacks a value that it needs.
void take_network(FunctionCallInfo fcinfo, StreetsCall* call);
// All arguments, in the same way.
void take(FunctionCallInfo fcinfo, StreetsCall* call);

}  // namespace streetgen::pg
