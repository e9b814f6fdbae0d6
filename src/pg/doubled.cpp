// streetgen._doubled: how much of each axis lies on another one.
#include "streetgen/doubled.hpp"

#include <string>
#include <vector>

#include "argument.hpp"
#include "border.hpp"
#include "wkb.hpp"

extern "C" {
#include <catalog/pg_type.h>
#include <utils/array.h>
}

STREETGEN_FUNCTION(streetgen_doubled) {
  using namespace streetgen;
  using namespace streetgen::pg;
  Datum *axes, *levels;
  int count, count_levels;
  bool* nulls;
  deconstruct_array(PG_GETARG_ARRAYTYPE_P(0), BYTEAOID, -1, false, 'i', &axes, &nulls, &count);
  deconstruct_array(PG_GETARG_ARRAYTYPE_P(1), INT4OID, 4, true, 'i', &levels, &nulls,
                    &count_levels);
  if (count != count_levels)
    ereport(ERROR, (errcode(ERRCODE_ARRAY_SUBSCRIPT_ERROR),
                    errmsg("levels has %d elements for %d axes", count_levels, count)));
  if (array_contains_nulls(PG_GETARG_ARRAYTYPE_P(0)) ||
      array_contains_nulls(PG_GETARG_ARRAYTYPE_P(1)))
    ereport(ERROR, (errcode(ERRCODE_NULL_VALUE_NOT_ALLOWED), errmsg("an axis or level is NULL")));
  for (int i = 0; i < count; ++i) axes[i] = PointerGetDatum(PG_DETOAST_DATUM_PACKED(axes[i]));
  const double near = PG_GETARG_FLOAT8(2);
  Slot<std::vector<double>>* slot = make_slot<std::vector<double>>(CurrentMemoryContext);
  const Outcome outcome = compute([&] {
    std::vector<Line> lines;
    std::vector<int> of_line;
    for (int i = 0; i < count; ++i) {
      lines.push_back(read_line(bytes_of(axes[i]), "axis " + std::to_string(i + 1)).line);
      of_line.push_back(DatumGetInt32(levels[i]));
    }
    slot->value = new std::vector<double>(doubled(lines, of_line, in_range(near, 0, 1000, "near")));
  });
  report(outcome);
  for (int i = 0; i < count; ++i) axes[i] = Float8GetDatum((*slot->value)[i]);
  PG_RETURN_ARRAYTYPE_P(construct_array(axes, count, FLOAT8OID, 8, true, 'd'));
}
