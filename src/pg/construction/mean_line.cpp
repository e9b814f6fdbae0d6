// streetgen.mean_line: the line in the middle of several.
#include "streetgen/mean_line.hpp"

#include "frame/geometry_result.hpp"
#include "value/line_array.hpp"

STREETGEN_FUNCTION(streetgen_mean_line) {
  using namespace streetgen;
  using namespace streetgen::pg;
  const LineArray lines = take_lines(PG_GETARG_ARRAYTYPE_P(0), "lines");
  return geometry_result(fcinfo, [&](GivenGeometry& given) {
    Form form;
    const Line mean = mean_line(read_lines(lines, "line", &form));
    if (mean.empty()) return;
    given.present = true;
    given.wkb = write_line(mean, {form.srid, false});
  });
}
