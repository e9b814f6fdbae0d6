// Demand as both kinds of simulation read it.
#pragma once

#include <vector>

#include "streetgen/traffic.hpp"
#include "streetgen/traffic_demand.hpp"

namespace streetgen {

// Refuses (invalid_input) a link that is not there and a flow that is not 0 or more.
void check_entries(const TrafficNetwork& network, const std::vector<TrafficEntry>& entries);

// By row of TrafficNetwork::next the share of those on a link that go on there, in sum 1.  Refused
// (invalid_input): a share that is not 0 or more, or of a link that does not follow.
std::vector<double> turn_shares(const TrafficNetwork& network, const std::vector<TurnShare>& turns);

}  // namespace streetgen
