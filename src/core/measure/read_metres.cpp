#include <algorithm>
#include <cmath>

#include "measure/measure_reader.hpp"
#include "streetgen/measure_text.hpp"

namespace streetgen {

namespace {

constexpr double foot = 0.3048, inch = 0.0254;

constexpr UnitName lengths[] = {{"m", 1},
                                {"metre", 1},
                                {"metres", 1},
                                {"meter", 1},
                                {"meters", 1},
                                {"metro", 1},
                                {"metros", 1},
                                {"mtr", 1},
                                {"mts", 1},
                                {"cm", 0.01},
                                {"mm", 0.001},
                                {"dm", 0.1},
                                {"km", 1000},
                                {"'", foot},
                                {"ft", foot},
                                {"foot", foot},
                                {"feet", foot},
                                {"\"", inch},
                                {"in", inch},
                                {"inch", inch},
                                {"inches", inch},
                                {"yd", 0.9144},
                                {"yds", 0.9144},
                                {"yard", 0.9144},
                                {"yards", 0.9144},
                                {"us-ft", 1200 / 3937.0},
                                {"ftus", 1200 / 3937.0}};

bool is_feet(const std::string& unit) { return size_of(lengths, unit) == foot; }

// The inches behind feet, as in 12'6", 12'-6" or 12 ft 6 in; without a mark they follow ' alone.
std::optional<double> take_inches(MeasureReader& reader, const std::string& feet) {
  const std::size_t place = reader.place();
  reader.take("-");
  const bool hyphen = reader.place() != place;
  const auto inches = reader.take_number();
  if (inches && *inches >= 0 && *inches < 12) {
    const std::string unit = reader.take_unit();
    if (unit.empty() ? feet == "'" && !hyphen : size_of(lengths, unit) == inch) return inches;
  }
  reader.back_to(place);
  return std::nullopt;
}

std::optional<Quantity> take_length(MeasureReader& reader) {
  const auto number = reader.take_number();
  if (!number) return std::nullopt;
  const std::size_t behind = reader.place();
  const std::string unit = reader.take_unit();
  // The word between two lengths is no unit.
  if (unit == "to") reader.back_to(behind);
  if (unit.empty() || unit == "to") return Quantity{*number};
  const auto size = size_of(lengths, unit);
  if (!size) return std::nullopt;
  if (is_feet(unit))
    if (const auto inches = take_inches(reader, unit))
      return Quantity{*number + *inches / 12, foot};
  return Quantity{*number, size};
}

void skip_about(MeasureReader& reader) {
  for (const std::string_view about : {"~", "ca.", "c.", "approx."})
    if (reader.take(about)) return;
  for (const std::string_view about : {"ca", "about", "approx"})
    if (reader.take_word(about)) return;
}

}  // namespace

std::optional<double> read_metres(std::string_view text, std::string_view unit) {
  const auto usual = size_of(lengths, unit);
  MeasureReader reader(text);
  skip_about(reader);
  std::vector<Quantity> quantities;
  do {
    const auto length = take_length(reader);
    if (!length) return std::nullopt;
    quantities.push_back(*length);
  } while (reader.take("-") || reader.take(";") || reader.take_word("to"));
  if (!usual || !reader.at_end()) return std::nullopt;
  const std::vector<double> metres = in_units(quantities, *usual);
  const auto [least, most] = std::minmax_element(metres.begin(), metres.end());
  if (metres.size() > 1 && *least < 0) return std::nullopt;
  const double middle = *least == *most ? *least : *least / 2 + *most / 2;
  if (!std::isfinite(middle)) return std::nullopt;
  return middle;
}

}  // namespace streetgen
