// Vertices of a path move off the grid that they were found on.
#pragma once

#include <vector>

#include "streetgen/road_design.hpp"

namespace streetgen {

// Moves vertices in plan and height, and leaves out those that no longer help, as long as the road
// gets cheaper, all curves fit and no side is too steep. The first step is half a cell. Vertices by
// hand and the ends stay.
void settle_vertices(const DesignSite& site, double cell, std::vector<PathVertex>& path);

}  // namespace streetgen
