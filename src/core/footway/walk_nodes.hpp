// Ends of walks that are one node.
#pragma once

#include <utility>
#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

constexpr double one_place = 0.01;  // metres; places of a level that are nearer are one

using Place = std::pair<double, double>;
inline Place place_of(const Point& p) { return {p.x, p.y}; }

// A piece of a line between two nodes.
struct WalkPiece {
  int line = 0;  // index
  int level = 0;
  Line geometry;
};

// Ends of one level that are nearer than `one_place`, also by way of others, become the first of
// them from west to east. Pieces that lie within one place go.
void join_near_ends(std::vector<WalkPiece>& pieces);

}  // namespace streetgen
