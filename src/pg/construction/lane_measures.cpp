// streetgen._lane_measures: the same places along an axis and along a lane.
#include "streetgen/lane_measures.hpp"

#include "frame/argument.hpp"
#include "frame/array_row.hpp"
#include "frame/border.hpp"
#include "frame/geometry_result.hpp"
#include "value/wkb.hpp"

STREETGEN_FUNCTION(streetgen_lane_measures) {
  using namespace streetgen;
  using namespace streetgen::pg;
  const std::string_view axis = take_bytes(fcinfo, 0), lane = take_bytes(fcinfo, 1);
  const double widest = PG_GETARG_FLOAT8(2);
  const double first = PG_GETARG_FLOAT8(3), last = PG_GETARG_FLOAT8(4);
  InitMaterializedSRF(fcinfo, MAT_SRF_USE_EXPECTED_DESC);
  auto* slot = make_slot<NumberColumns>(CurrentMemoryContext);
  const Outcome outcome = compute([&] {
    slot->value = new NumberColumns;
    LaneMeasures measures = lane_measures(
        read_line(axis, "axis").line, read_line(lane, "lane").line,
        in_range(widest, 0, 1e4, "widest"), finite(first, "first"), finite(last, "last"));
    *slot->value = {std::move(measures.on_axis), std::move(measures.on_lane)};
  });
  report(outcome);
  give_row(*slot->value, result_of(fcinfo));
  PG_RETURN_NULL();
}
