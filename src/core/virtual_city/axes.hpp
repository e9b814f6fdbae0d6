// From the streets of a virtual city to its axes.
#pragma once

#include <cstdint>
#include <vector>

#include "streetgen/virtual_city.hpp"
#include "virtual_city/street.hpp"

namespace streetgen {

// An axis a street, or a stretch of one; in the order of the streets.
std::vector<CityAxis> street_axes(const std::vector<CityStreet>& streets,
                                  const CityOptions& options);

// Puts roundabouts in the place of crossings: the axes through them are cut, and a closed axis
// each is appended.  `key`: of the random numbers.
void make_roundabouts(std::vector<CityAxis>& axes, std::uint64_t key, const CityOptions& options);

}  // namespace streetgen
