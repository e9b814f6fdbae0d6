// Numbers as texts of files.
#pragma once

#include <string>

namespace streetgen::pg {

// Of a finite number, with so many digits behind the point (0 to 15); never -0.
void append_decimal(std::string& text, double value, int digits);

// The same without the zeros at its end. What lies in the middle goes to the even digit, as PostGIS
// writes it, in the shortest decimals that mean the number.
void append_short_decimal(std::string& text, double value, int digits);

}  // namespace streetgen::pg
