#include "value/value_array.hpp"

namespace streetgen::pg {

ValueArray take_values(FunctionCallInfo fcinfo, int argument, Oid type, int count,
                       const char* name) {
  const int size = type == BOOLOID ? 1 : type == INT4OID ? 4 : 8;
  const char align = type == BOOLOID ? 'c' : type == INT4OID ? 'i' : 'd';
  ValueArray array;
  bool* nulls;
  deconstruct_array(PG_GETARG_ARRAYTYPE_P(argument), type, size, true, align, &array.values, &nulls,
                    &array.count);
  if (count != any_count && array.count != count)
    ereport(ERROR, (errcode(ERRCODE_ARRAY_SUBSCRIPT_ERROR),
                    errmsg("%s has %d elements, expected %d", name, array.count, count)));
  for (int i = 0; i < array.count; ++i)
    if (nulls[i])
      ereport(ERROR, (errcode(ERRCODE_NULL_VALUE_NOT_ALLOWED),
                      errmsg("element %d of %s is NULL", i + 1, name)));
  return array;
}

}  // namespace streetgen::pg
