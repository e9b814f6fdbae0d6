#pragma once

#include "streetgen/streets.hpp"

namespace streetgen {

// Invariant: surfaces belong to affected edges and nodes, and their rings are closed and finite.
void check_surfaces(const Streets& streets);

}  // namespace streetgen
