// The length or the cost of what cannot be.
#pragma once

#include <limits>

namespace streetgen {

constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace streetgen
