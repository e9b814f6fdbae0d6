// Control points as an argument of SQL: an array of streetgen.street_control.
#pragma once

#include <vector>

#include "frame/composite_rows.hpp"
#include "streetgen/control_point.hpp"

namespace streetgen::pg {

struct ControlRows {
  int count;
  Column axis_id, abscissa, kind, direction;
};

ControlRows take_controls(FunctionCallInfo fcinfo, int argument);

// Another kind or direction, or a place that is not finite: Error{invalid_input}.
std::vector<ControlPoint> read_controls(const ControlRows& rows);

}  // namespace streetgen::pg
