// Slip lanes that end at a street.
#pragma once

#include <vector>

#include "lane/lane_wishes.hpp"
#include "streetgen/street.hpp"

namespace streetgen {

class SlipLaneEnds {
 public:
  SlipLaneEnds(const Streets& streets, const LaneWishes& wishes);

  // Whether an edge ends there as a slip lane, which waits. All its traffic comes beside an island
  // to a street that goes straight on with traffic of its own, and joins that within 60 degrees.
  // The street has no lane more behind the node for it.
  bool waits(int edge, bool at_start) const;

 private:
  bool beside_island(int edge) const;
  // Lanes of motor traffic that come to the node by an end, or leave it.
  int count(int slot, bool comes) const;
  // Radians, either way.
  double turn_onto(int from, int onto) const;

  const Streets& streets_;
  const LaneWishes& wishes_;
  std::vector<std::vector<int>> ends_;  // by node: slots of the edges there
};

}  // namespace streetgen
