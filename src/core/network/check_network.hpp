#pragma once

#include "streetgen/network.hpp"

namespace streetgen {

// Invariant: edges start and end at their nodes, and abscissas grow along each axis.
void check_network(const Network& network);

}  // namespace streetgen
