// streetgen._doubled: how much of each axis lies on another one.
#include "streetgen/duplicate_line.hpp"

#include <vector>

#include "frame/argument.hpp"
#include "frame/border.hpp"
#include "value/line_array.hpp"

STREETGEN_FUNCTION(streetgen_doubled) {
  using namespace streetgen;
  using namespace streetgen::pg;
  const LineArray axes = take_lines(PG_GETARG_ARRAYTYPE_P(0), "axes");
  ArrayType* given = PG_GETARG_ARRAYTYPE_P(1);
  Datum* levels;
  int count;
  bool* nulls;
  deconstruct_array(given, INT4OID, 4, true, 'i', &levels, &nulls, &count);
  if (count != axes.count)
    ereport(ERROR, (errcode(ERRCODE_ARRAY_SUBSCRIPT_ERROR),
                    errmsg("levels has %d elements for %d axes", count, axes.count)));
  if (array_contains_nulls(given))
    ereport(ERROR, (errcode(ERRCODE_NULL_VALUE_NOT_ALLOWED), errmsg("a level is NULL")));
  const double near = PG_GETARG_FLOAT8(2);
  Slot<std::vector<double>>* slot = make_slot<std::vector<double>>(CurrentMemoryContext);
  const Outcome outcome = compute([&] {
    std::vector<int> of_axis;
    for (int i = 0; i < count; ++i) of_axis.push_back(DatumGetInt32(levels[i]));
    slot->value = new std::vector<double>(
        doubled(read_lines(axes, "axis", nullptr), of_axis, in_range(near, 0, 1000, "near")));
  });
  report(outcome);
  Datum* metres = static_cast<Datum*>(palloc(sizeof(Datum) * (count + 1)));
  for (int i = 0; i < count; ++i) metres[i] = Float8GetDatum((*slot->value)[i]);
  PG_RETURN_ARRAYTYPE_P(construct_array(metres, count, FLOAT8OID, 8, true, 'd'));
}
