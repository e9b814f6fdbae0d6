// streetgen._streets: the whole pipeline over a set of axes, one row per result.
#include "progress.hpp"
#include "streets_call.hpp"
#include "streets_input.hpp"
#include "streets_rows.hpp"

namespace streetgen::pg {
namespace {

Rows computed_rows(const StreetsCall& call) {
  const StreetsInput input = read_input(call);
  const Streets result = streets(input.axes, input.settings, input.overrides, input.former);
  const Lanes traffic = lanes(result, input.lanes, input.lane_overrides, input.lane_settings);
  return rows_of(result, traffic,
                 interconnections(result, input.axes, traffic.lanes, input.restrictions,
                                  input.interconnection_settings),
                 input.srid, input.has_z);
}

}  // namespace
}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_streets) {
  using namespace streetgen::pg;
  StreetsCall call;
  take(fcinfo, &call);
  InitMaterializedSRF(fcinfo, 0);
  Slot<Rows>* slot = make_slot<Rows>(CurrentMemoryContext);
  begin_progress(call.count);
  const Outcome outcome = compute([&] { slot->value = new Rows(computed_rows(call)); });
  end_progress();
  report(outcome);
  give(*slot->value, reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo));
  PG_RETURN_NULL();
}
