// What is known of paint, as three arguments of SQL: arrays of streetgen.street_junction, of
// streetgen.street_lane_change and of streetgen.street_leaving.
#pragma once

#include "frame/composite_rows.hpp"
#include "streetgen/lane.hpp"

namespace streetgen::pg {

struct PaintRows {
  struct {
    int count;
    Column axis_id, x, y, kind;
  } junctions;
  struct {
    int count;
    Column axis_id, abscissa, lane_from, lane_to, change;
  } changes;
  struct {
    int count;
    Column axis_id, forward, backward, bare;
  } leaving;
};

PaintRows take_paint(FunctionCallInfo fcinfo, int junctions, int changes, int leaving);

// Another kind or change, or a place that is not finite: Error{invalid_input}.
PaintRules read_paint(const PaintRows& rows);

}  // namespace streetgen::pg
