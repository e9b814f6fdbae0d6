// streetgen._lay_paint: paint on a lane before the crossings there.
#include "streetgen/crossing_line.hpp"

#include "frame/argument.hpp"
#include "frame/border.hpp"
#include "value/line_array.hpp"
#include "value/value_array.hpp"
#include "value/wkb.hpp"

extern "C" {
#include <funcapi.h>
#include <utils/tuplestore.h>
}

namespace {

using namespace streetgen;
using namespace streetgen::pg;

struct Given {
  std::string_view way;
  double width;
  bool between_junctions;
  LineArray crossings;  // surfaces
  LineArray lines;
  ValueArray arrows, stays;
  CrossingRules rules;
};

std::vector<LaidPaint> lay(const Given& given) {
  const DrivenLane lane{read_line(given.way, "lane").line, in_range(given.width, 0, 1000, "width"),
                        given.between_junctions};
  std::vector<MultiPolygon> crossings;
  for (int i = 0; i < given.crossings.count; ++i)
    crossings.push_back(read_surface(bytes_of(given.crossings.values[i]), "crossing"));
  std::vector<PaintOnLane> paint;
  for (Line& line : read_lines(given.lines, "line", nullptr)) {
    const std::size_t i = paint.size();
    paint.push_back({std::move(line), DatumGetBool(given.arrows.values[i]),
                     DatumGetBool(given.stays.values[i])});
  }
  return lay_before_crossings(lane, crossings, paint, given.rules);
}

}  // namespace

STREETGEN_FUNCTION(streetgen_lay_paint) {
  InitMaterializedSRF(fcinfo, 0);
  Given given{take_bytes(fcinfo, 0),
              PG_GETARG_FLOAT8(1),
              PG_GETARG_BOOL(2),
              take_lines(PG_GETARG_ARRAYTYPE_P(3), "crossings"),
              take_lines(PG_GETARG_ARRAYTYPE_P(4), "lines"),
              {},
              {},
              {PG_GETARG_FLOAT8(7), PG_GETARG_FLOAT8(8)}};
  given.arrows = take_values(fcinfo, 5, BOOLOID, given.lines.count, "arrows");
  given.stays = take_values(fcinfo, 6, BOOLOID, given.lines.count, "stays");
  Slot<std::vector<LaidPaint>>* slot = make_slot<std::vector<LaidPaint>>(CurrentMemoryContext);
  report(compute([&] { slot->value = new std::vector<LaidPaint>(lay(given)); }));
  auto* result = reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo);
  for (std::size_t i = 0; i < slot->value->size(); ++i) {
    const LaidPaint& laid = (*slot->value)[i];
    const Slide slide = laid.slide.value_or(Slide{});
    Datum values[7] = {Int32GetDatum(static_cast<int32>(i + 1)),
                       BoolGetDatum(laid.slide.has_value()),
                       BoolGetDatum(laid.has_room),
                       Float8GetDatum(slide.cosine),
                       Float8GetDatum(slide.sine),
                       Float8GetDatum(slide.shift.x),
                       Float8GetDatum(slide.shift.y)};
    bool nulls[7] = {};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  }
  PG_RETURN_NULL();
}
