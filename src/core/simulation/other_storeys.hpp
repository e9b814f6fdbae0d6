// Links one over the other.
#pragma once

#include <vector>

#include "streetgen/traffic.hpp"

namespace streetgen {

// Leaves those places that are up to `storey` metres farther in height than the nearest one.
void drop_other_storeys(const TrafficNetwork& network, double height, std::vector<NearPlace>& near);

}  // namespace streetgen
