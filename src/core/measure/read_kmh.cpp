#include <algorithm>
#include <cmath>

#include "measure/measure_reader.hpp"
#include "measure/zone_limit.hpp"
#include "streetgen/measure_text.hpp"

namespace streetgen {

namespace {

constexpr UnitName speeds[] = {{"km/h", 1},    {"kmh", 1},       {"kph", 1},      {"kmph", 1},
                               {"kmt", 1},     {"km/t", 1},      {"km/u", 1},     {"mph", mile},
                               {"mi/h", mile}, {"knots", 1.852}, {"knot", 1.852}, {"kn", 1.852},
                               {"kts", 1.852}, {"kt", 1.852},    {"m/s", 3.6}};

// The country and the colon at the start of a zone, such as de: or be-vlg:.
std::string_view take_country(MeasureReader& reader) {
  const std::string_view text = reader.rest();
  const std::size_t colon = text.find(':');
  if (colon != 2 && !(colon != text.npos && colon > 3 && colon < 7 && text[2] == '-')) return {};
  reader.take(text.substr(0, colon + 1));
  return text.substr(0, colon);
}

// Nothing where a speed is not said, or is none.
std::optional<Quantity> take_speed(MeasureReader& reader) {
  if (reader.take_word("walk")) return Quantity{walking_speed, 1};
  const std::string_view country = take_country(reader);
  reader.take("zone");
  reader.take(":");
  const auto number = reader.take_number();
  if (number && *number >= 0) {
    const std::string unit = reader.take_unit();
    const auto size = size_of(speeds, unit);
    if (!unit.empty() && !size) return std::nullopt;
    if (size || country.empty()) return Quantity{*number, size};
    return Quantity{*number, signs_in_miles(country) ? mile : 1};
  }
  if (number || country.empty()) return std::nullopt;
  const std::string_view zone = reader.rest().substr(0, reader.rest().find_first_of(" ;|"));
  const auto limit = zone_limit(country, zone);
  reader.take(zone);
  if (!limit) return std::nullopt;
  return Quantity{*limit, 1};
}

}  // namespace

std::optional<double> read_kmh(std::string_view text, std::string_view unit) {
  const auto usual = size_of(speeds, unit);
  MeasureReader reader(text);
  std::vector<Quantity> quantities;
  // A list of lanes says nothing of some.
  while (reader.take("|")) continue;
  bool goes_on = true;
  while (goes_on) {
    const auto speed = take_speed(reader);
    if (!speed) return std::nullopt;
    quantities.push_back(*speed);
    goes_on = reader.take(";") || reader.take("-");
    while (reader.take("|")) goes_on = !reader.at_end();
  }
  if (!usual || !reader.at_end()) return std::nullopt;
  const std::vector<double> kmh = in_units(quantities, *usual);
  const double highest = *std::max_element(kmh.begin(), kmh.end());
  if (!std::isfinite(highest)) return std::nullopt;
  return highest;
}

}  // namespace streetgen
