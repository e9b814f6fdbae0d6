// Points that are one in files: of those that lie too near to each other, the first.
#pragma once

#include <cstdint>
#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

// For each place the index of the first one that stands for it: the nearest before it that stands
// for itself and lies within `reach` metres in space, else its own.  A place of a group other than
// 0 takes one of its own group alone.
std::vector<int> first_within(const std::vector<Point>& places,
                              const std::vector<std::int64_t>& groups, double reach);

}  // namespace streetgen
