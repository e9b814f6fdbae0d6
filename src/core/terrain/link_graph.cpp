#include "terrain/link_graph.hpp"

namespace streetgen {

LinkGraph::Ways LinkGraph::ways(std::size_t from, std::size_t to) const {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Ways ways{std::vector<double>(towns_, infinite), std::vector<std::size_t>(towns_, from)};
  std::vector<bool> settled(towns_, false);
  ways.length[from] = 0;
  for (std::size_t round = 0; round < towns_; ++round) {
    std::size_t next = everywhere;
    for (std::size_t i = 0; i < towns_; ++i)
      if (!settled[i] && ways.length[i] < infinite &&
          (next == everywhere || ways.length[i] < ways.length[next]))
        next = i;
    if (next == everywhere || next == to) break;
    settled[next] = true;
    const double* row = &length_[next * towns_];
    for (std::size_t i = 0; i < towns_; ++i)
      if (ways.length[next] + row[i] < ways.length[i]) {
        ways.length[i] = ways.length[next] + row[i];
        ways.before[i] = next;
      }
  }
  return ways;
}

}  // namespace streetgen
