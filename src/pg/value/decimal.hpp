// Numbers as texts of files.
#pragma once

#include <string>

namespace streetgen::pg {

// Of a finite number, with so many digits behind the point (0 to 15); never -0.
void append_decimal(std::string& text, double value, int digits);

}  // namespace streetgen::pg
