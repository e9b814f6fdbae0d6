// Edges that lie on another axis.
#pragma once

#include <vector>

#include "streetgen/street.hpp"

namespace streetgen {

// Takes twins out of the network and reports all that lies on another axis, as
// streetgen/street_network.hpp says.  axes: by edge.
void drop_twins(Network& network, const std::vector<const StreetAxis*>& axes, double tolerance);

}  // namespace streetgen
