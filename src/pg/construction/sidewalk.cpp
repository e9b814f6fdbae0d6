// streetgen._sidewalks: the strips behind kerbs.
#include "streetgen/sidewalk.hpp"

#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "frame/argument.hpp"
#include "frame/border.hpp"
#include "value/line_array.hpp"
#include "value/stored.hpp"
#include "value/value_array.hpp"
#include "value/wkb.hpp"

extern "C" {
#include <funcapi.h>
#include <utils/builtins.h>
#include <utils/tuplestore.h>
}

namespace {

using namespace streetgen;
using namespace streetgen::pg;

struct Elements {
  Datum* values = nullptr;
  bool* nulls = nullptr;
};

// As many as there are kerbs; raises 2202E otherwise, and 22004 for a NULL that means nothing.
Elements take_elements(FunctionCallInfo fcinfo, int argument, Oid type, int size, int count,
                       const char* name, bool may_be_null) {
  Elements elements;
  int given;
  deconstruct_array(PG_GETARG_ARRAYTYPE_P(argument), type, size, true,
                    size == 1   ? TYPALIGN_CHAR
                    : size == 4 ? TYPALIGN_INT
                                : TYPALIGN_DOUBLE,
                    &elements.values, &elements.nulls, &given);
  if (given != count)
    ereport(ERROR, (errcode(ERRCODE_ARRAY_SUBSCRIPT_ERROR),
                    errmsg("%s has %d elements for %d kerbs", name, given, count)));
  for (int i = 0; i < count && !may_be_null; ++i)
    if (elements.nulls[i])
      ereport(ERROR, (errcode(ERRCODE_NULL_VALUE_NOT_ALLOWED),
                      errmsg("element %d of %s is NULL", i + 1, name)));
  return elements;
}

struct Given {
  LineArray lines;
  Elements levels, widths, across, ends, by_hand, wanted;
  ValueArray course_kerbs, course_shares, course_widths;
};

std::vector<SidewalkKerb> kerbs_of(const Given& given) {
  std::vector<SidewalkKerb> kerbs;
  for (Line& line : read_lines(given.lines, "kerb", nullptr)) {
    const std::size_t i = kerbs.size();
    SidewalkKerb kerb;
    kerb.line = std::move(line);
    kerb.level = DatumGetInt32(given.levels.values[i]);
    if (!given.widths.nulls[i])
      kerb.width = in_range(DatumGetFloat8(given.widths.values[i]), 0, 50, "width");
    kerb.across = DatumGetBool(given.across.values[i]);
    kerb.ends = DatumGetBool(given.ends.values[i]);
    kerb.by_hand = DatumGetBool(given.by_hand.values[i]);
    kerb.wanted = DatumGetBool(given.wanted.values[i]);
    kerbs.push_back(std::move(kerb));
  }
  for (int i = 0; i < given.course_kerbs.count; ++i) {
    const int kerb = DatumGetInt32(given.course_kerbs.values[i]) - 1;
    if (kerb < 0 || kerb >= static_cast<int>(kerbs.size()) || !kerbs[kerb].width)
      throw Error(ErrorKind::invalid_input,
                  "place " + std::to_string(i + 1) + " is of no kerb with a width");
    kerbs[kerb].course.push_back(
        {in_range(DatumGetFloat8(given.course_shares.values[i]), -1e6, 1e6, "share"),
         in_range(DatumGetFloat8(given.course_widths.values[i]), 0, 50, "width")});
  }
  return kerbs;
}

Datum geometry_datum(const MultiPolygon& surface, int srid) {
  Slot<Stored>* slot = make_slot<Stored>(CurrentMemoryContext);
  const Outcome outcome = compute([&] {
    slot->value = new Stored(stored_surface(surface, {srid, false}));
  });
  report(outcome);
  void* out = palloc(VARSIZE(slot->value->get()));
  memcpy(out, slot->value->get(), VARSIZE(slot->value->get()));
  return PointerGetDatum(out);
}

}  // namespace

STREETGEN_FUNCTION(streetgen_sidewalks) {
  InitMaterializedSRF(fcinfo, 0);
  for (int i = 0; i < 12; ++i)
    if (PG_ARGISNULL(i)) PG_RETURN_NULL();
  Given given{};
  given.lines = take_lines(PG_GETARG_ARRAYTYPE_P(0), "kerbs");
  const int count = given.lines.count;
  given.levels = take_elements(fcinfo, 1, INT4OID, 4, count, "levels", false);
  given.widths = take_elements(fcinfo, 2, FLOAT8OID, 8, count, "widths", true);
  given.across = take_elements(fcinfo, 3, BOOLOID, 1, count, "across", false);
  given.ends = take_elements(fcinfo, 4, BOOLOID, 1, count, "ends", false);
  given.by_hand = take_elements(fcinfo, 5, BOOLOID, 1, count, "by_hand", false);
  given.wanted = take_elements(fcinfo, 6, BOOLOID, 1, count, "wanted", false);
  given.course_kerbs = take_values(fcinfo, 7, INT4OID, any_count, "course_kerbs");
  const int places = given.course_kerbs.count;
  given.course_shares = take_values(fcinfo, 8, FLOAT8OID, places, "course_shares");
  given.course_widths = take_values(fcinfo, 9, FLOAT8OID, places, "course_widths");
  const double transition = PG_GETARG_FLOAT8(10);
  const int srid = PG_GETARG_INT32(11);
  Slot<std::vector<Sidewalk>>* slot = make_slot<std::vector<Sidewalk>>(CurrentMemoryContext);
  const Outcome outcome = compute([&] {
    slot->value = new std::vector<Sidewalk>(
        find_sidewalks(kerbs_of(given), in_range(transition, 0, 100, "transition")));
  });
  report(outcome);
  auto* result = reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo);
  MemoryContext per_row =
      AllocSetContextCreate(CurrentMemoryContext, "streetgen row", ALLOCSET_DEFAULT_SIZES);
  for (const Sidewalk& sidewalk : *slot->value) {
    MemoryContext before = MemoryContextSwitchTo(per_row);
    Datum values[4] = {Int32GetDatum(sidewalk.kerb + 1), Float8GetDatum(sidewalk.width),
                       geometry_datum(sidewalk.surface, srid),
                       CStringGetTextDatum(method_name(sidewalk.method))};
    bool nulls[4] = {false, false, false, false};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
    MemoryContextSwitchTo(before);
    MemoryContextReset(per_row);
  }
  PG_RETURN_NULL();
}
