// What edges go about, by their order about each node alone: lines that cross without a node part
// nothing.
#pragma once

#include <functional>
#include <vector>

#include "streetgen/network.hpp"

namespace streetgen {

// An edge from its start on, or from its end back.
using Walk = std::vector<EdgeEnd>;

// At each node a walk goes on with what lies leftmost, so that nothing is between it and the ground
// on its left.  Each edge is walked once along and once back; a dead end is walked to its end and
// back.  A walk begins with its smallest edge, along before back; in the order of these.  The edges
// that count are walked as if there were no others.
std::vector<Walk> walks(const Network& network, const std::function<bool(const Edge&)>& counts);

}  // namespace streetgen
