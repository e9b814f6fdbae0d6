// Which lane goes on as which, where a street goes on with as many lanes or with another number.
#pragma once

#include <vector>

#include "streetgen/lane.hpp"

namespace streetgen {

// A lane of one direction where it meets the node.
struct LaneAbreast {
  unsigned turns = 0;
  double aside = 0;  // metres from the axis to its middle, to the left as one drives
};

// Lane i of `in` goes on as lane i + succession() of `out`; one that would come to lie outside of
// these ends and leads into the outermost, and lanes of `out` that none goes on as begin there.
// Both lists run from left to right as one drives, and neither is empty.  Of lanes too many those
// end that are marked to merge, on their side; beyond these, and of lanes that begin, the places
// decide: the least move aside, else the outer ones change.
int succession(const std::vector<LaneAbreast>& in, const std::vector<LaneAbreast>& out,
               DrivingSide side);

}  // namespace streetgen
