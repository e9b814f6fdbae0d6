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

void append_short_decimal(std::string& text, double value, int digits) {
  if (!std::isfinite(value)) throw Error(ErrorKind::invalid_input, "a number is not finite");
  char room[std::numeric_limits<double>::max_exponent10 + 32];
  const char* end = std::to_chars(room, room + sizeof room, value, std::chars_format::fixed).ptr;
  const char* point = std::find(static_cast<const char*>(room), end, '.');
  if (end - point == digits + 2 && end[-1] == '5') {
    const char before_it = end[-2] == '.' ? end[-3] : end[-2];
    value += (before_it % 2 == 0 ? -0.1 : 0.1) * std::copysign(std::pow(10.0, -digits), value);
  }
  const std::size_t before = text.size();
  append_decimal(text, value, digits);
  if (text.find('.', before) == std::string::npos) return;
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
}

}  // namespace streetgen::pg
