// streetgen._clusters: the cluster of each point.
#include <vector>

#include "frame/argument.hpp"
#include "frame/border.hpp"
#include "streetgen/cluster.hpp"

extern "C" {
#include <catalog/pg_type.h>
#include <utils/array.h>
}

STREETGEN_FUNCTION(streetgen_clusters) {
  using namespace streetgen;
  using namespace streetgen::pg;
  Datum *x, *y;
  int count, count_y;
  bool* nulls;
  deconstruct_array(PG_GETARG_ARRAYTYPE_P(0), FLOAT8OID, 8, true, 'd', &x, &nulls, &count);
  deconstruct_array(PG_GETARG_ARRAYTYPE_P(1), FLOAT8OID, 8, true, 'd', &y, &nulls, &count_y);
  if (count != count_y)
    ereport(ERROR, (errcode(ERRCODE_ARRAY_SUBSCRIPT_ERROR),
                    errmsg("y has %d elements for %d of x", count_y, count)));
  const int k = PG_GETARG_INT32(2);
  Slot<std::vector<int>>* slot = make_slot<std::vector<int>>(CurrentMemoryContext);
  const Outcome outcome = compute([&] {
    std::vector<Point> points;
    for (int i = 0; i < count; ++i)
      points.push_back({finite(DatumGetFloat8(x[i]), "x"), finite(DatumGetFloat8(y[i]), "y"), 0});
    slot->value = new std::vector<int>(clusters(points, k));
  });
  report(outcome);
  for (int i = 0; i < count; ++i) x[i] = Int32GetDatum((*slot->value)[i]);
  PG_RETURN_ARRAYTYPE_P(construct_array(x, count, INT4OID, 4, true, 'i'));
}
