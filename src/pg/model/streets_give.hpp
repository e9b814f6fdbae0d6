// The rows of a table into the tuplestore of a call.
#pragma once

#include <initializer_list>

#include "frame/border.hpp"
#include "model/streets_rows.hpp"

namespace streetgen::pg {

// A column that has a cast from bytea is a geometry.
Datum give(FunctionCallInfo fcinfo, const Table& table, const ComputedStreets& computed,
           const Named& named);

// The same for a call with the number of kept streets, and then with the ids of these in their
// order.
Datum give_kept(FunctionCallInfo fcinfo, const Table& table,
                std::initializer_list<Ids Named::*> arguments);

// The function streetgen._computed_NAME of a table NAME_table; its arguments after the first are
// the ids of `Named` that it names.
#define STREETGEN_TABLE(name, ...)                         \
  STREETGEN_FUNCTION(streetgen_computed_##name) {          \
    return give_kept(fcinfo, name##_table, {__VA_ARGS__}); \
  }

}  // namespace streetgen::pg
