// streetgen._detect_arcs: the arcs in a line, a row each.
#include <string>
#include <vector>

#include "frame/argument.hpp"
#include "frame/border.hpp"
#include "frame/geometry_result.hpp"
#include "streetgen/detect_arcs.hpp"
#include "value/wkb.hpp"

extern "C" {
#include <funcapi.h>
#include <utils/tuplestore.h>
}

namespace streetgen::pg {
namespace {

struct GivenArcs {
  std::vector<DetectedArc> arcs;
  std::vector<std::string> centres, curves;
};

void give(const GivenArcs& found, ReturnSetInfo* result) {
  for (std::size_t i = 0; i < found.arcs.size(); ++i) {
    const DetectedArc& arc = found.arcs[i];
    const Datum values[5] = {bytes_datum(found.centres[i]), Float8GetDatum(arc.radius),
                             bytes_datum(found.curves[i]), Int32GetDatum(arc.support),
                             Float8GetDatum(arc.deviation)};
    const bool nulls[5] = {false};
    tuplestore_putvalues(result->setResult, result->setDesc, const_cast<Datum*>(values),
                         const_cast<bool*>(nulls));
  }
}

}  // namespace
}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_detect_arcs) {
  using namespace streetgen;
  using namespace streetgen::pg;
  const std::string_view line = take_bytes(fcinfo, 0);
  double numbers[4];
  for (int i = 0; i < 4; ++i) numbers[i] = PG_GETARG_FLOAT8(1 + i);
  InitMaterializedSRF(fcinfo, 0);
  Slot<GivenArcs>* slot = make_slot<GivenArcs>(CurrentMemoryContext);
  const Outcome outcome = compute([&] {
    slot->value = new GivenArcs;
    const ReadLine read = read_line(line, "line");
    ArcBounds bounds;
    bounds.radius_least = in_range(numbers[0], 1e-3, 1e6, "radius_least");
    bounds.radius_greatest = in_range(numbers[1], bounds.radius_least, 1e6, "radius_greatest");
    bounds.tolerance = in_range(numbers[2], 1e-6, 1e3, "tolerance");
    bounds.turn_least = in_range(numbers[3], 0, 360, "turn_least");
    GivenArcs& found = *slot->value;
    found.arcs = detect_arcs(read.line, bounds);
    for (const DetectedArc& arc : found.arcs) {
      found.centres.push_back(write_point(arc.centre, {read.srid, false}));
      found.curves.push_back(write_arc(arc.arc, {read.srid, false}));
    }
  });
  report(outcome);
  give(*slot->value, reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo));
  PG_RETURN_NULL();
}
