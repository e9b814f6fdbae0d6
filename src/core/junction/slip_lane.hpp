// Slip lanes: short one-way ways that cut a corner.
#pragma once

#include <vector>

#include "streetgen/junction.hpp"
#include "support/disjoint_sets.hpp"

namespace streetgen {

// An edge as the rules look at it.
struct RuleEdge {
  int from_node = 0, to_node = 0;
  double length = 0;                 // metres
  Point leaves_from{}, leaves_to{};  // unit directions in which it leaves its nodes
  bool along = true, against = true;
  std::int64_t name = 0;
  bool crossed = false, on_ring = false;
  std::optional<bool> by_hand{};

  bool one_way() const { return along != against; }
};

// A slip lane, its edges in the direction of its traffic, and the edges from its ends to the
// corner.
struct SlipLane {
  std::vector<int> edges;
  int from_node = 0, to_node = 0;
  int before = 0, behind = 0;  // edges: from its start to the corner, from the corner to its end
  int corner = 0;              // a node there
  double length = 0;           // metres, of its edges
};

// `ends`: by node, its edges.  `groups`: nodes that are one corner whatever slip lanes say.
std::vector<SlipLane> find_slip_lanes(const std::vector<RuleEdge>& edges,
                                      const JunctionRules& rules,
                                      const std::vector<std::vector<int>>& ends, Groups& groups);

}  // namespace streetgen
