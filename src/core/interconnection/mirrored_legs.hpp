// The legs of a node as a mirror shows them.
#pragma once

#include <vector>

#include "interconnection/movement.hpp"

namespace streetgen {

// Turns legs, lanes and movements about, with what is known of the lanes and found for their pairs.
// The same once more gives them back as they were.
void mirror(std::vector<Leg>& legs, std::vector<Movement>& movements);

}  // namespace streetgen
