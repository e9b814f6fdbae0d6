// Lengths and speeds of texts; NULL for a text that means neither.
#include "streetgen/measure_text.hpp"

#include <string_view>

#include "frame/border.hpp"
#include "frame/geometry_result.hpp"

namespace streetgen::pg {
namespace {

using ReadMeasure = std::optional<double> (*)(std::string_view, std::string_view);

Datum measure(FunctionCallInfo fcinfo, ReadMeasure read) {
  const std::string_view text = take_bytes(fcinfo, 0), unit = take_bytes(fcinfo, 1);
  std::optional<double> number;
  const Outcome outcome = compute([&] { number = read(text, unit); });
  report(outcome);
  if (!number) PG_RETURN_NULL();
  PG_RETURN_FLOAT8(*number);
}

}  // namespace
}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_metres) {
  return streetgen::pg::measure(fcinfo, streetgen::read_metres);
}

STREETGEN_FUNCTION(streetgen_kmh) { return streetgen::pg::measure(fcinfo, streetgen::read_kmh); }
