// The lanes of edges, as ramps count them.
#pragma once

#include <vector>

#include "lane/lane_wishes.hpp"
#include "streetgen/lane.hpp"
#include "streetgen/ramp.hpp"
#include "streetgen/street.hpp"

namespace streetgen {

// Says of what lanes ramps are made: those of each edge, after roundabouts and overrides, and the
// outer side of traffic.
void count_ramp_lanes(RampRules& rules, const std::vector<StreetAxis>& axes, LaneWishes wishes,
                      const LaneSettings& settings);

}  // namespace streetgen
