// The turn restrictions of each node, and the movements there that they forbid.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "interconnection/movement.hpp"
#include "streetgen/network.hpp"

namespace streetgen {

class NodeRestrictions {
 public:
  // `tolerance` of the network, in metres.
  NodeRestrictions(const Network& network, const std::vector<TurnRestriction>& restrictions,
                   double tolerance);

  // `axes`: those of the legs.
  void mark(int node, const std::vector<std::int64_t>& axes, const std::vector<Leg>& legs,
            std::vector<Movement>& movements) const;

 private:
  std::map<int, std::vector<const TurnRestriction*>> of_node_;
};

}  // namespace streetgen
