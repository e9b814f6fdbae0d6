// Elements of OpenDRIVE that are lists of numbers.
#include <cmath>
#include <string>
#include <vector>

#include "frame/border.hpp"
#include "frame/geometry_result.hpp"
#include "streetgen/error.hpp"
#include "value/decimal.hpp"
#include "value/number_array.hpp"

extern "C" {
#include <utils/builtins.h>
}

namespace streetgen::pg {
namespace {

// The text that work appends to, as the result of a function.
template <class Work>
Datum text_result(Work&& work) {
  auto* slot = make_slot<std::string>(CurrentMemoryContext);
  const Outcome outcome = compute([&] {
    slot->value = new std::string;
    work(*slot->value);
  });
  report(outcome);
  return PointerGetDatum(
      cstring_to_text_with_len(slot->value->data(), static_cast<int>(slot->value->size())));
}

// A straight polynomial from a station on.
struct Straight {
  double at = 0, value = 0, slope = 0;
};

// Whether one says the same as the one before it, to the digits that are written.
bool goes_on(const Straight& before, const Straight& next) {
  constexpr double digit = 1e-4, slope_digit = 2e-6;
  return std::abs(before.slope - next.slope) <= slope_digit &&
         std::abs(before.value + before.slope * (next.at - before.at) - next.value) <= digit;
}

void append(std::string& text, const char* words, double value, int digits) {
  text += words;
  append_decimal(text, value, digits);
}

}  // namespace
}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_decimal) {
  using namespace streetgen::pg;
  const double value = PG_GETARG_FLOAT8(0);
  const int digits = PG_GETARG_INT32(1);
  return text_result([&](std::string& text) { append_decimal(text, value, digits); });
}

// The columns of a chain, the origin and the digits of a coordinate.
STREETGEN_FUNCTION(streetgen_opendrive_plan) {
  using namespace streetgen;
  using namespace streetgen::pg;
  constexpr int columns = 7;
  NumberArray given[columns];
  for (int i = 0; i < columns; ++i) given[i] = take_numbers(fcinfo, i);
  const double x0 = PG_GETARG_FLOAT8(columns), y0 = PG_GETARG_FLOAT8(columns + 1);
  const int digits = PG_GETARG_INT32(columns + 2);
  return text_result([&](std::string& text) {
    std::vector<double> of[columns];
    for (int i = 0; i < columns; ++i) {
      of[i] = read_numbers(given[i], 1, "chain");
      if (of[i].size() != of[0].size())
        throw Error(ErrorKind::invalid_input, "the columns of a chain are of different length");
    }
    const auto& [s, x, y, heading, length, curvature, curvature_end] = of;
    text = "<planView>";
    for (std::size_t i = 0; i < s.size(); ++i) {
      append(text, "<geometry s=\"", s[i], 7);
      append(text, "\" x=\"", x[i] - x0, digits);
      append(text, "\" y=\"", y[i] - y0, digits);
      append(text, "\" hdg=\"", heading[i], 9);
      append(text, "\" length=\"", length[i], 7);
      if (curvature[i] != curvature_end[i]) {
        append(text, "\"><spiral curvStart=\"", curvature[i], 12);
        append(text, "\" curvEnd=\"", curvature_end[i], 12);
        text += "\"/></geometry>";
      } else if (curvature[i] == 0) {
        text += "\"><line/></geometry>";
      } else {
        append(text, "\"><arc curvature=\"", curvature[i], 12);
        text += "\"/></geometry>";
      }
    }
    text += "</planView>";
  });
}

// Polynomials that are straight from station to station.
STREETGEN_FUNCTION(streetgen_opendrive_change) {
  using namespace streetgen;
  using namespace streetgen::pg;
  const std::string_view element = take_bytes(fcinfo, 0), place = take_bytes(fcinfo, 1);
  const NumberArray stations = take_numbers(fcinfo, 2), values = take_numbers(fcinfo, 3);
  return text_result([&](std::string& text) {
    const std::vector<double> at = read_numbers(stations, 1, "station");
    const std::vector<double> value = read_numbers(values, 1, "value");
    if (value.size() != at.size())
      throw Error(ErrorKind::invalid_input, "there is not a value for each station");
    Straight before;
    for (std::size_t i = 1; i < at.size(); ++i) {
      const Straight next{at[i - 1], value[i - 1], (value[i] - value[i - 1]) / (at[i] - at[i - 1])};
      if (i > 1 && goes_on(before, next)) continue;
      before = next;
      text.append("<").append(element).append(" ").append(place);
      append(text, "=\"", next.at, 7);
      append(text, "\" a=\"", next.value, 5);
      append(text, "\" b=\"", next.slope, 9);
      text += "\" c=\"0\" d=\"0\"/>";
    }
  });
}

// Polynomials: where each begins, and its four coefficients.
STREETGEN_FUNCTION(streetgen_opendrive_cubics) {
  using namespace streetgen;
  using namespace streetgen::pg;
  constexpr int columns = 5;
  constexpr const char* words[columns] = {"=\"", "\" a=\"", "\" b=\"", "\" c=\"", "\" d=\""};
  constexpr int digits[columns] = {7, 5, 9, 12, 15};
  const std::string_view element = take_bytes(fcinfo, 0), place = take_bytes(fcinfo, 1);
  NumberArray given[columns];
  for (int i = 0; i < columns; ++i) given[i] = take_numbers(fcinfo, 2 + i);
  return text_result([&](std::string& text) {
    std::vector<double> of[columns];
    for (int i = 0; i < columns; ++i) {
      of[i] = read_numbers(given[i], 1, "polynomial");
      if (of[i].size() != of[0].size())
        throw Error(ErrorKind::invalid_input, "the columns of polynomials are of different length");
    }
    for (std::size_t k = 0; k < of[0].size(); ++k) {
      text.append("<").append(element).append(" ").append(place);
      for (int i = 0; i < columns; ++i) append(text, words[i], of[i][k], digits[i]);
      text += "\"/>";
    }
  });
}
