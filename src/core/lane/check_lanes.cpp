#include "lane/check_lanes.hpp"

#include <set>
#include <utility>

#include "geometry/closed_ring.hpp"
#include "support/invariant.hpp"

namespace streetgen {

void check_lanes(const Streets& streets, const Lanes& lanes) {
  if (!invariants_are_checked) return;
  std::set<std::pair<int, int>> numbers;
  for (std::size_t l = 0; l < lanes.lanes.size(); ++l) {
    const Lane& lane = lanes.lanes[l];
    must_hold(lane.edge >= 0 && lane.edge < static_cast<int>(streets.network.edges.size()),
              "a lane lies on an edge", l);
    must_hold(lane.line.size() > 1, "a lane has a line", l);
    must_hold(numbers.emplace(lane.edge, lane.ordinality).second, "lanes have a number each", l);
    must_hold(lane.position == 1 || (l > 0 && lanes.lanes[l - 1].edge == lane.edge &&
                                     lanes.lanes[l - 1].position + 1 == lane.position),
              "lanes follow each other from the left", l);
    must_hold(has_closed_rings(lane.surface), "rings of lanes are closed", l);
  }
}

}  // namespace streetgen
