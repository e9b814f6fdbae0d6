// The rows of a table into the tuplestore of a call.
#pragma once

#include "frame/border.hpp"
#include "model/streets_rows.hpp"

namespace streetgen::pg {

// A column that has a cast from bytea is a geometry.
Datum give(FunctionCallInfo fcinfo, const Table& table, const ComputedStreets& computed,
           const Named& named);

}  // namespace streetgen::pg
