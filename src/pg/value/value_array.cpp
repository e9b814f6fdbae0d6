#include "value/value_array.hpp"

namespace streetgen::pg {

ValueArray values_of(Datum given, Oid type, const char* name) {
  const int size = type == BOOLOID ? 1 : type == INT4OID ? 4 : 8;
  const char align = type == BOOLOID ? 'c' : type == INT4OID ? 'i' : 'd';
  ValueArray array;
  bool* nulls;
  deconstruct_array(DatumGetArrayTypeP(given), type, size, true, align, &array.values, &nulls,
                    &array.count);
  for (int i = 0; i < array.count; ++i)
    if (nulls[i])
      ereport(ERROR, (errcode(ERRCODE_NULL_VALUE_NOT_ALLOWED),
                      errmsg("element %d of %s is NULL", i + 1, name)));
  return array;
}

ValueArray take_values(FunctionCallInfo fcinfo, int argument, Oid type, int count,
                       const char* name) {
  const ValueArray array = values_of(PG_GETARG_DATUM(argument), type, name);
  if (count != any_count && array.count != count)
    ereport(ERROR, (errcode(ERRCODE_ARRAY_SUBSCRIPT_ERROR),
                    errmsg("%s has %d elements, expected %d", name, array.count, count)));
  return array;
}

Datum bigints(const std::vector<std::int64_t>& numbers) {
  const int count = static_cast<int>(numbers.size());
  auto* datums = static_cast<Datum*>(palloc(sizeof(Datum) * (count + 1)));
  for (int i = 0; i < count; ++i) datums[i] = Int64GetDatum(numbers[i]);
  return PointerGetDatum(construct_array(datums, count, INT8OID, 8, true, TYPALIGN_DOUBLE));
}

Datum doubles(const std::vector<double>& numbers) {
  const int count = static_cast<int>(numbers.size());
  auto* datums = static_cast<Datum*>(palloc(sizeof(Datum) * (count + 1)));
  for (int i = 0; i < count; ++i) datums[i] = Float8GetDatum(numbers[i]);
  return PointerGetDatum(construct_array(datums, count, FLOAT8OID, 8, true, TYPALIGN_DOUBLE));
}

}  // namespace streetgen::pg
