#include "interconnection/check_interconnections.hpp"

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "support/invariant.hpp"

namespace streetgen {

namespace {

bool is_end_of(const Line& line, const Point& p) {
  return distance(line.front(), p) <= same_place || distance(line.back(), p) <= same_place;
}

}  // namespace

void check_interconnections(const Streets& streets, const std::vector<Lane>& lanes,
                            const std::vector<Interconnection>& paths) {
  if (!invariants_are_checked) return;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const Interconnection& path = paths[i];
    for (const int lane : {path.lane_in, path.lane_out}) {
      const Edge& edge = streets.network.edges.at(lanes.at(lane).edge);
      must_hold(edge.from_node == path.node || edge.to_node == path.node,
                "a path joins lanes of its node", i);
    }
    must_hold(path.line.size() > 1 && is_end_of(lanes[path.lane_in].line, path.line.front()) &&
                  is_end_of(lanes[path.lane_out].line, path.line.back()),
              "a path goes from the end of a lane to the end of another", i);
  }
}

}  // namespace streetgen
