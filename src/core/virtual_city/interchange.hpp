// What leads over the highway between two towns, and a diamond interchange.  Traffic keeps right.
#pragma once

#include <string>
#include <vector>

#include "virtual_city/highway.hpp"

namespace streetgen {

// Metres from the middle line of the highway to where ramps meet the road of the town.
double to_ramps(const Highway& highway);

// A road that crosses the highway at a station, from left to right: an approach, a bridge and
// another approach, each like `road`.  `vertices`: of the approaches, metres to the left of the
// middle line, descending.
std::vector<TownAxis> road_over(const Highway& highway, const HighwayStation& station,
                                const std::vector<double>& vertices, const TownAxis& road);

// The four ramps of a town's interchange at a station, each drawn with its traffic.
std::vector<TownAxis> ramps(const Highway& highway, const HighwayStation& station,
                            const TwoTownsOptions& options, const std::string& town);

}  // namespace streetgen
