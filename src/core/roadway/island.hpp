// Traffic islands: ground between streets that the fillets of its corners would swallow.
#pragma once

#include <cstddef>
#include <vector>

#include "layout/layout.hpp"
#include "layout/node_corner.hpp"

namespace streetgen {

struct CornerPlace {
  int node = 0;
  std::size_t gap = 0;  // index in Junction::ends of its first arm
  bool operator==(const CornerPlace& o) const { return node == o.node && gap == o.gap; }
};

// By node, by gap.
using SolvedCorners = std::vector<std::vector<SolvedCorner>>;

// The corners about each island: a face between the axes of one level, smaller than island_area and
// no longer about than twice the reach, whose flat kerbs leave room for a disc of 1 m. The fillets
// of its corners take that room away, or over 15 % of the ground between the kerbs. Each corner
// adds the nodes that it looked at to Junction::followed.
std::vector<CornerPlace> swallowed_islands(Layout& layout, const SolvedCorners& corners);

}  // namespace streetgen
