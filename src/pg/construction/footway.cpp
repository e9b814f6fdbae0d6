// streetgen._sidewalk_sources: which sides of streets footways run along.
#include "streetgen/footway.hpp"

#include "frame/argument.hpp"
#include "frame/border.hpp"
#include "value/line_array.hpp"
#include "value/value_array.hpp"

extern "C" {
#include <funcapi.h>
#include <utils/tuplestore.h>
}

namespace {

using namespace streetgen;
using namespace streetgen::pg;

struct GivenFootways {
  LineArray edges, footways;
  ValueArray edge_levels, footway_levels;
  ValueArray side_edges, lefts, kerbs_at_start, kerbs_at_end;
  FootwayMatch match;
};

std::vector<LevelLine> level_lines(const LineArray& array, const ValueArray& levels,
                                   const char* what) {
  std::vector<LevelLine> lines;
  for (Line& line : read_lines(array, what, nullptr))
    lines.push_back({std::move(line), DatumGetInt32(levels.values[lines.size()])});
  return lines;
}

std::vector<SidewalkSource> sources_of(const GivenFootways& given) {
  std::vector<StreetSide> sides;
  for (int i = 0; i < given.side_edges.count; ++i) {
    StreetSide side;
    side.edge = DatumGetInt32(given.side_edges.values[i]) - 1;
    if (side.edge < 0 || side.edge >= given.edges.count)
      throw Error(ErrorKind::invalid_input, "side " + std::to_string(i + 1) + " is of no edge");
    side.left = DatumGetBool(given.lefts.values[i]);
    side.kerb_at_start =
        in_range(DatumGetFloat8(given.kerbs_at_start.values[i]), -200, 200, "kerb_at_start");
    side.kerb_at_end =
        in_range(DatumGetFloat8(given.kerbs_at_end.values[i]), -200, 200, "kerb_at_end");
    sides.push_back(side);
  }
  return sidewalk_sources(level_lines(given.edges, given.edge_levels, "edge"), sides,
                          level_lines(given.footways, given.footway_levels, "footway"),
                          given.match);
}

Datum array_of(const std::vector<SidePlace>& course, double SidePlace::*value) {
  Datum* values = static_cast<Datum*>(palloc(sizeof(Datum) * (course.size() + 1)));
  for (std::size_t i = 0; i < course.size(); ++i) values[i] = Float8GetDatum(course[i].*value);
  return PointerGetDatum(construct_array(values, static_cast<int>(course.size()), FLOAT8OID, 8,
                                         FLOAT8PASSBYVAL, TYPALIGN_DOUBLE));
}

}  // namespace

STREETGEN_FUNCTION(streetgen_sidewalk_sources) {
  InitMaterializedSRF(fcinfo, 0);
  GivenFootways given;
  given.edges = take_lines(PG_GETARG_ARRAYTYPE_P(0), "edges");
  given.edge_levels = take_values(fcinfo, 1, INT4OID, given.edges.count, "edge_levels");
  given.footways = take_lines(PG_GETARG_ARRAYTYPE_P(2), "footways");
  given.footway_levels = take_values(fcinfo, 3, INT4OID, given.footways.count, "footway_levels");
  given.side_edges = take_values(fcinfo, 4, INT4OID, any_count, "side_edges");
  const int count = given.side_edges.count;
  given.lefts = take_values(fcinfo, 5, BOOLOID, count, "lefts");
  given.kerbs_at_start = take_values(fcinfo, 6, FLOAT8OID, count, "kerbs_at_start");
  given.kerbs_at_end = take_values(fcinfo, 7, FLOAT8OID, count, "kerbs_at_end");
  const double reach = PG_GETARG_FLOAT8(8);
  Slot<std::vector<SidewalkSource>>* slot =
      make_slot<std::vector<SidewalkSource>>(CurrentMemoryContext);
  report(compute([&] {
    given.match.distance = in_range(reach, 0, 50, "reach");
    slot->value = new std::vector<SidewalkSource>(sources_of(given));
  }));
  auto* result = reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo);
  for (const SidewalkSource& source : *slot->value) {
    Datum values[7] = {Int32GetDatum(source.side + 1),
                       Int32GetDatum(source.footway + 1),
                       Float8GetDatum(source.start),
                       Float8GetDatum(source.end),
                       Float8GetDatum(source.distance),
                       array_of(source.course, &SidePlace::abscissa),
                       array_of(source.course, &SidePlace::distance)};
    bool nulls[7] = {};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  }
  PG_RETURN_NULL();
}
