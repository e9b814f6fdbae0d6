// Which arms of a junction wait for others, where nobody has put a sign.
#pragma once

#include <cstdint>
#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

// An end of an edge at a node.
struct RankedArm {
  Point direction;  // unit, in which it leaves the node
  int importance = 99;
  double width = 0;  // metres, at the node
  std::int64_t axis_id = 0;
  bool comes = true, leaves = true;  // whether traffic comes to the node by it, and leaves it
};

// Of the most important arms, where there are three and more, all wait but two that traffic goes on
// between: the straighter pair, by ten degrees, then the wider, then that of the smaller axis_id.
// Less important arms wait for them.  By arm; nobody waits where traffic comes by one arm alone, or
// a street parts into its carriageways.
std::vector<bool> arms_that_wait(const std::vector<RankedArm>& arms);

}  // namespace streetgen
