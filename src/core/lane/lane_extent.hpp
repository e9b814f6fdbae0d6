// From where to where along its edge a lane leads.
#pragma once

#include "streetgen/street.hpp"

namespace streetgen {

// Metres along the edge.
struct LaneExtent {
  double from = 0, to = 0;
};

// Between the limits of the edge; where these crossed, about the place where they meet, so that
// paths of both nodes have as much ground as there is.
LaneExtent lane_extent(const Streets& streets, int edge);

}  // namespace streetgen
