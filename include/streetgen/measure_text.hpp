// Lengths and speeds as people write them: 3,5 m; 12'6"; ~6; 5-6 ft; 30 mph; 30;50; DE:urban.
//
// A number has one decimal mark, a point or a comma, and a unit of its own or of the texts beside
// it.  A text that is anything else means nothing.
#pragma once

#include <optional>
#include <string_view>

namespace streetgen {

// Metres; several lengths, as in 5-6 m, are the middle between the shortest and the longest.  A
// text without a unit is in `unit`, such as ft.
std::optional<double> read_metres(std::string_view text, std::string_view unit = "m");

// Kilometres an hour; of several speeds, as in 30;50, the highest.  Zones of countries have the
// limit that holds there by law, and walk is 7.  A text without a unit is in `unit`, such as mph.
std::optional<double> read_kmh(std::string_view text, std::string_view unit = "km/h");

}  // namespace streetgen
