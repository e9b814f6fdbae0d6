// The lanes of axes, as ramps count them.
#pragma once

#include <vector>

#include "streetgen/lane.hpp"
#include "streetgen/ramp.hpp"
#include "streetgen/street.hpp"

namespace streetgen {

// Fills in the lanes of each ramp axis and the outer side of traffic.  An axis without lanes has one
// along it.
void count_ramp_lanes(RampRules& rules, const std::vector<StreetAxis>& axes,
                      const std::vector<LanesOfAxis>& lanes, const LaneSettings& settings);

}  // namespace streetgen
