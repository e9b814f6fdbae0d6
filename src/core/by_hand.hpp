// Where the overrides of streets find their place in the network.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "ring.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {

// Where an edge touches a node.
struct EdgeEnd {
  int edge = 0;
  bool at_start = true;
};
inline int slot(const EdgeEnd& end) { return 2 * end.edge + (end.at_start ? 0 : 1); }

// The ends at a node, counter-clockwise.
using EndsOfNode = std::function<const std::vector<EdgeEnd>&(int)>;

// The least limit of an arm where three edges and more meet, and of one by hand.
double least_limit(const Arm& arm);

// By slot, metres from the node; `arms` by slot.
std::vector<std::optional<double>> limits_by_hand(const Network& network,
                                                  const std::vector<Arm>& arms,
                                                  const EndsOfNode& ends_of,
                                                  const std::vector<SectionLimitOverride>& puts);

// By node and index of the corner's first end there.
using RadiiByHand = std::map<std::pair<int, std::size_t>, double>;
RadiiByHand radii_by_hand(const Network& network, const std::vector<Arm>& arms,
                          const EndsOfNode& ends_of, const std::vector<CornerOverride>& wanted,
                          double tolerance);

}  // namespace streetgen
