// The corners of a node share the ground that they may close.
#pragma once

#include <vector>

#include "layout/node_corner.hpp"

namespace streetgen {

// Of one corner, in square metres.
struct CornerGround {
  double closed = 0;  // between its arc and the kerbs
  double least = 0;   // as a corner of 75 degrees closes, of the radius that is wanted
};

CornerGround corner_ground(const SolvedCorner& corner, double radius_wanted);

// The most that each corner may close so that all together close no more than `most`, each of them
// at least as much as one of 75 degrees would.
std::vector<double> shared_ground(const std::vector<CornerGround>& corners, double most);

}  // namespace streetgen
