// Many lines as one argument: an array of EWKB.
#pragma once

#include <string>
#include <vector>

#include "frame/border.hpp"
#include "value/wkb.hpp"

extern "C" {
#include <catalog/pg_type.h>
#include <utils/array.h>
}

namespace streetgen::pg {

struct LineArray {
  int count;
  Datum* values;
};

// Raises 22004 where one is NULL.
LineArray take_lines(ArrayType* array, const char* name);

// For the compute step; `what` and its number open the message of each Error. `form`, which may be
// null, is that of the last one.
std::vector<Line> read_lines(const LineArray& array, const std::string& what, Form* form);

}  // namespace streetgen::pg
