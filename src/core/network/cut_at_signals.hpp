// Signals in mid-block stand on a node of their own.
#pragma once

#include <vector>

#include "streetgen/control_point.hpp"
#include "streetgen/network.hpp"
#include "streetgen/street.hpp"

namespace streetgen {

// Cuts edges where signals stand in mid-block: the edge becomes two, which meet at a node of its
// axis and place.  Signals on a node of two edges stay on it.  Roundabouts are not cut.  `axes` by
// edge, also afterwards.
void cut_at_signals(Network& network, std::vector<const StreetAxis*>& axes,
                    const ControlRules& rules);

}  // namespace streetgen
