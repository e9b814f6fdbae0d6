#include "lane/slip_lane_end.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"

namespace streetgen {

namespace {

constexpr double joining_metres = 10;  // of an edge that give its direction
constexpr double straightest_turn = M_PI / 6 + same_angle;
constexpr double steepest_end = M_PI / 3 + same_angle;
constexpr double straighter = M_PI / 36;

}  // namespace

SlipLaneEnds::SlipLaneEnds(const Streets& streets, const LaneWishes& wishes)
    : streets_(streets), wishes_(wishes), ends_(streets.network.nodes.size()) {
  const std::vector<Edge>& edges = streets.network.edges;
  for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
    ends_[edges[e].from_node].push_back(2 * e);
    ends_[edges[e].to_node].push_back(2 * e + 1);
  }
}

bool SlipLaneEnds::beside_island(int edge) const {
  const std::vector<Beside>& sides = streets_.beside.sides;
  return !sides.empty() &&
         (sides[2 * edge] == Beside::island || sides[2 * edge + 1] == Beside::island);
}

int SlipLaneEnds::count(int slot, bool comes) const {
  const std::vector<LaneWish> lanes = wishes_.of(streets_.network.edges[slot / 2]).lanes;
  const bool along_axis = (slot % 2 == 1) == comes;
  return static_cast<int>(std::count_if(lanes.begin(), lanes.end(), [&](const LaneWish& lane) {
    return drives(lane.kind) && (lane.both_ways || lane.along_axis == along_axis);
  }));
}

double SlipLaneEnds::turn_onto(int from, int onto) const {
  const auto outwards = [&](int slot) {
    const Line& line = streets_.network.edges[slot / 2].line;
    const double total = length(line), along = std::min(joining_metres, total);
    const Point place = position_at(line, slot % 2 == 0 ? along : total - along).point;
    return planar(place - (slot % 2 == 0 ? line.front() : line.back()));
  };
  const Point comes = outwards(from) * -1, goes = outwards(onto);
  return std::abs(std::atan2(cross(comes, goes), dot(comes, goes)));
}

bool SlipLaneEnds::waits(int edge, bool at_start) const {
  if (!beside_island(edge)) return false;
  const int own = 2 * edge + (at_start ? 0 : 1), lanes = count(own, true);
  if (lanes == 0 || count(own, false) > 0) return false;
  const Edge& found = streets_.network.edges[edge];
  const std::vector<int>& ends = ends_[at_start ? found.from_node : found.to_node];
  return std::any_of(ends.begin(), ends.end(), [&](int onto) {
    if (onto == own || turn_onto(own, onto) > steepest_end) return false;
    return std::any_of(ends.begin(), ends.end(), [&](int from) {
      if (from == own || from == onto || turn_onto(from, onto) > straightest_turn) return false;
      const int before = count(from, true), behind = count(onto, false);
      return turn_onto(own, onto) > turn_onto(from, onto) + straighter && lanes <= before &&
             behind > 0 && behind < before + lanes;
    });
  });
}

}  // namespace streetgen
