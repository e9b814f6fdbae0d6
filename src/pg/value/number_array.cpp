#include "value/number_array.hpp"

#include <cmath>

extern "C" {
#include <catalog/pg_type.h>
#include <utils/array.h>
}

namespace streetgen::pg {

NumberArray take_numbers(FunctionCallInfo fcinfo, int argument) {
  NumberArray array;
  if (PG_ARGISNULL(argument)) return array;
  bool* nulls = nullptr;
  deconstruct_array(PG_GETARG_ARRAYTYPE_P(argument), FLOAT8OID, 8, true, 'd', &array.values, &nulls,
                    &array.count);
  for (int i = 0; i < array.count; ++i)
    if (nulls[i])
      ereport(ERROR, (errcode(ERRCODE_NULL_VALUE_NOT_ALLOWED),
                      errmsg("number %d of argument %d is NULL", i + 1, argument + 1)));
  return array;
}

std::vector<double> read_numbers(const NumberArray& array, int each, const std::string& name) {
  if (array.count % each != 0)
    throw Error(ErrorKind::invalid_input, name + " has " + std::to_string(array.count) +
                                              " numbers, no rows of " + std::to_string(each));
  std::vector<double> numbers;
  numbers.reserve(array.count);
  for (int i = 0; i < array.count; ++i) {
    numbers.push_back(DatumGetFloat8(array.values[i]));
    if (!std::isfinite(numbers.back()))
      throw Error(ErrorKind::invalid_input, "number " + std::to_string(i % each + 1) + " of row " +
                                                std::to_string(i / each + 1) + " of " + name +
                                                " is not finite");
  }
  return numbers;
}

}  // namespace streetgen::pg
