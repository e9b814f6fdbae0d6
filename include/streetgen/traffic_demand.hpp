// Traffic that enters a network, and where it turns.  Flows are cars a second.
#pragma once

#include <cstdint>

namespace streetgen {

// Cars that come from outside at the start of a link.
struct TrafficEntry {
  std::int32_t link = -1;
  double flow = 0;
  std::int32_t route = -1;  // that its cars follow, -1: none; a flow through cells has none
};

// How many of those on a link go on to a next one, in relation to its other shares.  A next link
// without one has the share 0 where another next link has one; a link without any goes straight on.
struct TurnShare {
  std::int32_t link = -1, next = -1;
  double share = 0;
};

}  // namespace streetgen
