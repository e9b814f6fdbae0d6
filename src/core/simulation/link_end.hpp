// The end of a link without a next one: traffic leaves there, or changes to a lane that goes on.
#pragma once

#include "streetgen/traffic.hpp"

namespace streetgen {

// Whether a link ends beside one that goes on, to which cars may change: a merging lane.
inline bool merges_beside(const TrafficNetwork& network, int link) {
  if (!network.next.of(link).empty()) return false;
  for (const LinkBeside& b : network.beside.of(link))
    if (b.may_change && !b.opposite && !network.next.of(b.link).empty()) return true;
  return false;
}

inline bool leaves_at_end(const TrafficNetwork& network, int link) {
  return network.next.of(link).empty() && !merges_beside(network, link);
}

// Whether two movements begin in one lane: the cars on them follow each other.
inline bool begin_together(const TrafficNetwork& network, int link, int other) {
  const auto mine = network.before.of(link), theirs = network.before.of(other);
  return !mine.empty() && !theirs.empty() && mine[0] == theirs[0];
}

}  // namespace streetgen
