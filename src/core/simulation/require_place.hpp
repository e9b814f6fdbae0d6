// Places at which cars may stand.
#pragma once

#include <cstdint>

#include "streetgen/traffic.hpp"

namespace streetgen {

// Refuses (invalid_input) a car off its link, and one on none.
void require_place(const TrafficNetwork& network, std::int64_t car_id, const LinkPlace& place);

}  // namespace streetgen
