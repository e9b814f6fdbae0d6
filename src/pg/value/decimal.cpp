#include "value/decimal.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "streetgen/error.hpp"

namespace streetgen::pg {

void append_decimal(std::string& text, double value, int digits) {
  if (!std::isfinite(value)) throw Error(ErrorKind::invalid_input, "a number is not finite");
  char room[std::numeric_limits<double>::max_exponent10 + 32];
  const int shown = std::clamp(digits, 0, 15);
  const char* end =
      std::to_chars(room, room + sizeof room, value, std::chars_format::fixed, shown).ptr;
  const char* begin = room;
  if (*begin == '-' && std::all_of(begin + 1, end, [](char c) { return c == '0' || c == '.'; }))
    ++begin;
  text.append(begin, end);
}

}  // namespace streetgen::pg
