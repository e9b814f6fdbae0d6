// An array of float8 as one argument, rows of it beside each other.
#pragma once

#include <string>
#include <vector>

#include "frame/border.hpp"

namespace streetgen::pg {

struct NumberArray {
  int count = 0;
  Datum* values = nullptr;
};

// Raises 22004 where an element is NULL; an argument that is NULL has no numbers.
NumberArray take_numbers(FunctionCallInfo fcinfo, int argument);

// For the compute step: finite numbers, `each` a row; `name` opens the message of each Error.
std::vector<double> read_numbers(const NumberArray& array, int each, const std::string& name);

}  // namespace streetgen::pg
