#pragma once

#include <vector>

#include "streetgen/interconnection.hpp"
#include "streetgen/lane.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {

// Invariant: every path joins two lanes that touch its node, and starts and ends at an end of each.
void check_interconnections(const Streets& streets, const std::vector<Lane>& lanes,
                            const std::vector<Interconnection>& paths);

}  // namespace streetgen
