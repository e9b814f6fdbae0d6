// streetgen._kerbs_by_area: the kerbs of an axis where its roadway was surveyed as areas.
#include "streetgen/kerbs_by_area.hpp"

#include "frame/geometry_result.hpp"
#include "value/line_array.hpp"

STREETGEN_FUNCTION(streetgen_kerbs_by_area) {
  using namespace streetgen;
  using namespace streetgen::pg;
  const std::string_view axis = take_bytes(fcinfo, 0);
  const LineArray areas = take_lines(PG_GETARG_ARRAYTYPE_P(1), "areas");
  Slot<std::optional<KerbsByArea>>* slot =
      make_slot<std::optional<KerbsByArea>>(CurrentMemoryContext);
  report(compute([&] {
    std::vector<MultiPolygon> grounds;
    for (int i = 0; i < areas.count; ++i)
      grounds.push_back(read_surface(bytes_of(areas.values[i]), "area " + std::to_string(i + 1)));
    slot->value =
        new std::optional<KerbsByArea>(kerbs_by_area(read_line(axis, "axis").line, grounds));
  }));
  if (!*slot->value) PG_RETURN_NULL();
  Datum values[2] = {Float8GetDatum((*slot->value)->width),
                     Float8GetDatum((*slot->value)->roadway_offset)};
  PG_RETURN_ARRAYTYPE_P(construct_array(values, 2, FLOAT8OID, 8, FLOAT8PASSBYVAL, TYPALIGN_DOUBLE));
}
