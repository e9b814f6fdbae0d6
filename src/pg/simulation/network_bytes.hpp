// A network of traffic as a bytea: functions of SQL hand it to each other.
#pragma once

#include <string>
#include <string_view>

#include "streetgen/traffic.hpp"

namespace streetgen::pg {

std::string network_bytes(const TrafficNetwork& network);

// Refuses bytes that network_bytes did not write, and what is no sound network:
// Error{invalid_input}.
TrafficNetwork read_network(std::string_view bytes);

}  // namespace streetgen::pg
