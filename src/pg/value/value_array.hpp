// Values of fixed size as one argument: an array without NULL.
#pragma once

#include <cstdint>
#include <vector>

#include "frame/border.hpp"

extern "C" {
#include <catalog/pg_type.h>
#include <utils/array.h>
}

namespace streetgen::pg {

struct ValueArray {
  int count;
  Datum* values;
};

constexpr int any_count = -1;

// The elements of an argument, as many as `count`, of type bool, int4, int8 or float8; raises 2202E
// or, where one is NULL, 22004.
ValueArray take_values(FunctionCallInfo fcinfo, int argument, Oid type, int count,
                       const char* name);

// The same of an array that stands in a row.
ValueArray values_of(Datum array, Oid type, const char* name);

// Arrays of bigint and of float8.
Datum bigints(const std::vector<std::int64_t>& numbers);
Datum doubles(const std::vector<double>& numbers);

}  // namespace streetgen::pg
