#include "value/control_rows.hpp"

#include "frame/argument.hpp"

extern "C" {
#include <catalog/pg_type.h>
}

namespace streetgen::pg {

ControlRows take_controls(FunctionCallInfo fcinfo, int argument) {
  const Rows controls = rows(fcinfo, argument, "control points");
  return {controls.count, column(controls, "axis_id", INT8OID),
          column(controls, "abscissa", FLOAT8OID), column(controls, "kind", TEXTOID),
          column_or_null(controls, "direction", TEXTOID)};
}

std::vector<ControlPoint> read_controls(const ControlRows& rows) {
  using Direction = ControlPoint::Direction;
  std::vector<ControlPoint> controls;
  for (int i = 0; i < rows.count; ++i) {
    ControlPoint control;
    control.axis_id = DatumGetInt64(rows.axis_id.values[i]);
    control.abscissa =
        finite(DatumGetFloat8(rows.abscissa.values[i]), "abscissa of a control point");
    control.kind =
        word_of<ControlKind>(text_of(rows.kind.values[i]), "kind of a control point",
                             {{"signals", ControlKind::signals},
                              {"stop", ControlKind::stop},
                              {"yield", ControlKind::yield},
                              {"mini_roundabout", ControlKind::mini_roundabout},
                              {"pedestrian_crossing", ControlKind::pedestrian_crossing}});
    if (!rows.direction.nulls[i])
      control.direction =
          word_of<Direction>(text_of(rows.direction.values[i]), "direction of a control point",
                             {{"direct", Direction::along},
                              {"reverse", Direction::against},
                              {"both", Direction::both}});
    controls.push_back(control);
  }
  return controls;
}

}  // namespace streetgen::pg
