// What must hold of every result; each function returns what does not, empty when all does.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "town.hpp"

namespace streetgen::fuzz {

using Faults = std::vector<std::string>;

// The pipeline: surfaces, limits and arcs valid and finite; the same again, and whatever the order
// of the axes.
Faults town_faults(std::uint64_t seed);

// The same with limits and corners by hand; each edge's limits lie on it, in order.
Faults override_faults(std::uint64_t seed);

// Ground of one owner each, edges covered.  Not reached yet in every such town: docs/quality.md.
Faults tiling_faults(std::uint64_t seed);

// Lanes of random wishes and overrides on such towns: sound, numbered, filling the roadway, inside
// it.
Faults lane_faults(std::uint64_t seed);

// Every pair of lanes, paths from lane to lane, no dead lane, whatever the order of the axes.
Faults interconnection_faults(std::uint64_t seed);

// The constructions that are usable alone, on random lines and numbers in their range.
Faults primitive_faults(std::uint64_t seed);

// The door for geometries: what is not finite is refused, broken bytes too.
Faults door_faults(std::uint64_t seed);

}  // namespace streetgen::fuzz
