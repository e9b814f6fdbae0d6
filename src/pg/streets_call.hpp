// The arguments of streetgen._streets: PostgreSQL's memory, plain pointers.
#pragma once

#include "border.hpp"

namespace streetgen::pg {

struct StreetsCall {
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
  Datum *override_width, *override_line;
  const char *lane_order, *driving_side;
  double lane_width_minimal, cycle_lane_width, parking_lane_width;
  bool edge_lines;
  Datum *speed;
  int restriction_count;
  Datum *restriction_from, *restriction_to, *restriction_x, *restriction_y;
  Datum *restriction_kind, *restriction_turn;
  bool u_turn;
  const char *trajectory;
  double trajectory_tolerance, trajectory_radius;
  Datum *changed, *beside, *outer;
  int former_edge_count, former_place_count;
  Datum *former_axis, *former_geom, *former_limits[4];
  Datum *former_x, *former_y, *former_met;
  int limit_count;
  Datum *limit_axis, *limit_abscissa, *limit_which;
  int corner_count;
  Datum *corner_a, *corner_b, *corner_x, *corner_y, *corner_radius;
};

// Raises where a list has a NULL or lists that belong together differ in length.
void take(FunctionCallInfo fcinfo, StreetsCall *call);

}  // namespace streetgen::pg
