// Limits of speed that hold by law in zones of countries, as OpenStreetMap names them.
#pragma once

#include <optional>
#include <string_view>

namespace streetgen {

// Km/h, by the code of a country (with its region where that has limits of its own) and the word
// of a zone, in small letters; nothing where either is not known.
std::optional<double> zone_limit(std::string_view country, std::string_view zone);

// Do the signs of a country give miles an hour?
bool signs_in_miles(std::string_view country);

constexpr double mile = 1.609344;
constexpr double walking_speed = 7;

}  // namespace streetgen
