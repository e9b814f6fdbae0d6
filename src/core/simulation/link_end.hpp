// The end of a link without a next one: traffic leaves there, or changes to a lane that goes on.
#pragma once

#include <vector>

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

// By link: whether one comes from it to an end without a change of lanes. From the inner lane of a
// roundabout nobody does, as all ways go round.
inline std::vector<char> links_that_lead_out(const TrafficNetwork& network) {
  std::vector<char> leads(network.size(), 0);
  std::vector<std::int32_t> reached;
  for (int link = 0; link < network.size(); ++link)
    if (network.next.of(link).empty()) reached.push_back(link);
  while (!reached.empty()) {
    const int link = reached.back();
    reached.pop_back();
    if (leads[link]) continue;
    leads[link] = 1;
    for (const std::int32_t before : network.before.of(link)) reached.push_back(before);
  }
  return leads;
}

// Whether two movements begin in one lane: the cars on them follow each other.
inline bool begin_together(const TrafficNetwork& network, int link, int other) {
  const auto mine = network.before.of(link), theirs = network.before.of(other);
  return !mine.empty() && !theirs.empty() && mine[0] == theirs[0];
}

}  // namespace streetgen
