#pragma once

#include "streetgen/streets.hpp"

namespace streetgen {

// Invariant: corners name edges that touch their node, and arcs lie on circles of their radius.
void check_corners(const Streets& streets);
// Invariant: every edge has two limits on it, and the first does not lie behind the second.
void check_limits(const Streets& streets);

}  // namespace streetgen
