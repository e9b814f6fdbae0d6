// Ends of axes that miss the street which they lead to.
#pragma once

#include <vector>

#include "streetgen/street.hpp"

namespace streetgen {

// Reports them, as streetgen/street_network.hpp says: the end, and how far the axis of the street
// is.  axes: by edge.
void report_missed_ends(Network& network, const std::vector<const StreetAxis*>& axes,
                        double tolerance);

}  // namespace streetgen
