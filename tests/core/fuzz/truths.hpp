// What must hold of every result; each function returns what does not, empty when all does.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "streetgen/streets.hpp"
#include "town.hpp"

namespace streetgen::fuzz {

using Faults = std::vector<std::string>;

// A random town and its streets, made once for all that is asked of them.
struct Made {
  explicit Made(std::uint64_t seed)
      : seed(seed),
        town(random_town(seed)),
        streets(streetgen::streets(town.axes, town.settings)) {}
  std::uint64_t seed;
  Town town;
  Streets streets;
};

// The pipeline: surfaces, limits and arcs valid and finite; the same whatever the order of the
// axes.
Faults town_faults(const Made& made);

// The same with limits and corners by hand; each edge's limits lie on it, in order.
Faults override_faults(const Made& made);

// Ground of one owner each, edges covered.  Not reached yet in every such town:
// docs/figures/streets.md.
Faults tiling_faults(const Made& made);

// Lanes of random wishes and overrides on such towns: sound, numbered, filling the roadway, inside
// it.
Faults lane_faults(const Made& made);

// Every pair of lanes, paths from lane to lane, no dead lane, whatever the order of the axes.
Faults interconnection_faults(const Made& made);

// The constructions that are usable alone, on random lines and numbers in their range.
Faults primitive_faults(std::uint64_t seed);

// Arc roads of such lines: finite, without gaps, their places found on them.
Faults alignment_faults(std::uint64_t seed);

// Texts of lengths and speeds made of their pieces: whatever they say is finite, with a point or a
// comma.
Faults measure_faults(std::uint64_t seed);

// The door for geometries: what is not finite is refused, broken bytes too.
Faults door_faults(std::uint64_t seed);

}  // namespace streetgen::fuzz
