#pragma once

#include "streetgen/lane.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {

// Invariant: lanes are numbered from 1 on every edge without a gap, and each has a line.
void check_lanes(const Streets& streets, const Lanes& lanes);

}  // namespace streetgen
