// The links that lead to a link, nearest first.
#pragma once

#include <algorithm>
#include <vector>

#include "streetgen/traffic.hpp"

namespace streetgen {

// Shows each way onto a link, and onto those behind it, once: `see(before, next, way)` gets a link,
// the one that it leads to, and the metres from its end to the start of the link asked for.  The
// search goes on behind a link where `see` says so and that starts nearer than `reach`.
template <class See>
void see_links_before(const TrafficNetwork& network, int link, double way, double reach, See see) {
  struct Reached {
    int link;
    double way;
  };
  const auto farther = [](const Reached& a, const Reached& b) { return a.way > b.way; };
  std::vector<Reached> reached{{link, way}};  // a heap, the nearest on top
  std::vector<int> seen;
  while (!reached.empty()) {
    std::pop_heap(reached.begin(), reached.end(), farther);
    const Reached nearest = reached.back();
    reached.pop_back();
    if (std::find(seen.begin(), seen.end(), nearest.link) != seen.end()) continue;
    seen.push_back(nearest.link);
    for (const int before : network.before.of(nearest.link)) {
      const double start = nearest.way + network.links[before].length;
      if (!see(before, nearest.link, nearest.way) || start >= reach) continue;
      reached.push_back({before, start});
      std::push_heap(reached.begin(), reached.end(), farther);
    }
  }
}

}  // namespace streetgen
