// In which order ways leave a node, counter-clockwise.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace streetgen {

// Radians: the direction of a place on a way, seen from the node, so many metres along the way.
using Heading = std::function<double(std::size_t way, double at)>;

// Whether one of two ways goes before the other; a strict weak order.
using WayRank = std::function<bool(std::size_t, std::size_t)>;

// Indices of the ways, 1 m from the node.  Ways that leave together go by where they part, up to
// 32 m.  Of ways that never part the first by rank lies beside the nearer of their neighbours, so
// that a mirror finds the same neighbours.
std::vector<std::size_t> leaving_order(std::size_t count, const Heading& heading,
                                       const WayRank& before);

}  // namespace streetgen
