#include <map>

#include "streetgen/walk_network.hpp"
#include "support/disjoint_sets.hpp"

namespace streetgen {

std::vector<int> walk_parts(const std::vector<WalkEnds>& links) {
  Groups parts(static_cast<int>(links.size()));
  std::map<std::int64_t, int> first_at;  // by node
  for (int l = 0; l < parts.size(); ++l)
    for (const std::int64_t node : {links[l].first, links[l].second})
      parts.join(first_at.emplace(node, l).first->second, l);
  std::vector<int> part_of;
  for (int l = 0; l < parts.size(); ++l) part_of.push_back(parts.of(l));
  return part_of;
}

}  // namespace streetgen
