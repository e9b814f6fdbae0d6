#include "kerb/check_kerbs.hpp"

#include <map>
#include <utility>

#include "support/invariant.hpp"

namespace streetgen {

void check_kerbs(const Streets& streets) {
  if (!invariants_are_checked) return;
  std::map<std::pair<int, KerbSide>, int> parts;
  for (std::size_t k = 0; k < streets.kerbs.size(); ++k) {
    const Kerb& kerb = streets.kerbs[k];
    const Edge& edge = streets.network.edges.at(kerb.edge);
    must_hold(kerb.line.size() > 1, "a kerb has a line", k);
    must_hold(kerb.part == ++parts[{kerb.edge, kerb.side}], "parts of kerbs follow each other", k);
    must_hold(kerb.node < 0 || kerb.node == edge.from_node || kerb.node == edge.to_node,
              "the kerb of an intersection names an edge that meets there", k);
  }
}

}  // namespace streetgen
