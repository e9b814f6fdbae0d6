#include "streetgen/road.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "geometry/polyline.hpp"
#include "road/edge_arcs.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

class RoadFinder {
 public:
  RoadFinder(const Network& network, const std::vector<std::vector<EdgeEnd>>& ends)
      : network_(network), ends_(ends), found_(network.edges.size(), false) {}

  std::vector<Road> roads() {
    std::vector<Road> roads;
    for (int e = 0; e < static_cast<int>(network_.edges.size()); ++e)
      if (!found_[e]) roads.push_back(road_along(e));
    return roads;
  }

 private:
  int node_of(const EdgeEnd& end) const {
    const Edge& edge = network_.edges[end.edge];
    return end.at_start ? edge.from_node : edge.to_node;
  }

  // The end from which the way goes on where it arrives at an end.
  std::optional<EdgeEnd> next(const EdgeEnd& arriving) const {
    const auto& ends = ends_[node_of(arriving)];
    if (ends.size() != 2) return std::nullopt;
    return slot(ends[0]) == slot(arriving) ? ends[1] : ends[0];
  }

  // The end at which the road begins that holds an edge, which runs along it.
  EdgeEnd first_end(int edge) const {
    EdgeEnd first{edge, true};
    while (const auto before = next(first)) {
      if (before->edge == edge) return {edge, true};
      first = {before->edge, !before->at_start};
    }
    return first;
  }

  Road road_along(int edge) {
    const EdgeEnd begin = first_end(edge);
    Road road;
    road.from_node = node_of(begin);
    for (std::optional<EdgeEnd> leaving = begin; leaving;) {
      const Edge& member = network_.edges[leaving->edge];
      road.members.push_back({leaving->edge, leaving->at_start, road.length});
      road.length += member.end_abscissa - member.start_abscissa;
      found_[leaving->edge] = true;
      const EdgeEnd arriving{leaving->edge, !leaving->at_start};
      road.to_node = node_of(arriving);
      leaving = next(arriving);
      if (leaving && leaving->edge == begin.edge) {
        road.closed = true;
        break;
      }
    }
    return road;
  }

  const Network& network_;
  const std::vector<std::vector<EdgeEnd>>& ends_;
  std::vector<bool> found_;
};

CurvedLine straight_pieces(const Line& line) {
  CurvedLine pieces;
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    pieces.push_back({{line[i], line[i], line[i + 1]}, false});
  return pieces;
}

CurvedLine curve_of(const Edge& edge, const EdgeArcs& arcs, int number) {
  if (!edge.curve.empty()) return edge.curve;
  if (const auto road = arcs.of(number)) return road->curve();
  return straight_pieces(distinct(planar(edge.line)));
}

void append(CurvedLine& road, CurvedLine edge, bool along) {
  if (!along) {
    std::reverse(edge.begin(), edge.end());
    for (RingPiece& piece : edge) std::swap(piece.arc.start, piece.arc.end);
  }
  road.insert(road.end(), edge.begin(), edge.end());
}

}  // namespace

std::vector<Road> roads(const Network& network, const std::vector<bool>& branching, double shift,
                        const std::vector<RoadOverride>& overrides) {
  auto ends = ends_by_node(network);
  for (std::size_t n = 0; n < branching.size(); ++n)
    if (branching[n]) ends[n].clear();
  std::vector<Road> found = RoadFinder(network, ends).roads();
  const EdgeArcs arcs(network, std::move(ends), shift, overrides);
  for (Road& road : found) {
    poll_cancel();
    for (const RoadMember& member : road.members)
      append(road.curve, curve_of(network.edges[member.edge], arcs, member.edge), member.along);
  }
  return found;
}

}  // namespace streetgen
