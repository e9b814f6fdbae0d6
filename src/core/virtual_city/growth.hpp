// The fractal of main and outgoing roads.
#pragma once

#include <cstdint>
#include <vector>

#include "streetgen/virtual_city.hpp"
#include "virtual_city/street.hpp"

namespace streetgen {

// The streets, first road first, each after its main road.
std::vector<CityStreet> grown_streets(const CityExtent& extent, std::uint64_t seed,
                                      const CityOptions& options);

}  // namespace streetgen
