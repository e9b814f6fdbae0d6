// The arc roads of the edges of a network.
#pragma once

#include <optional>
#include <vector>

#include "streetgen/arc_road.hpp"
#include "streetgen/road.hpp"

namespace streetgen {

// The ends of edges at each node.
std::vector<std::vector<EdgeEnd>> ends_by_node(const Network& network);

class EdgeArcs {
 public:
  // Edges go on from one another at nodes of two ends, but not where the node is branching.
  EdgeArcs(const Network& network, std::vector<std::vector<EdgeEnd>> ends, double shift,
           const std::vector<RoadOverride>& overrides);

  // The arc road of an edge; none where the edge is straight. Where two edges of one level go on
  // from one another, both leave the node along the mean of their directions, so that the road has
  // one tangent there.
  std::optional<ArcRoad> of(int edge) const;

 private:
  std::optional<Point> tangent_at(int node, const EdgeEnd& own) const;

  const Network& network_;
  std::vector<std::vector<EdgeEnd>> ends_;
  double shift_;
  std::vector<std::vector<RoadOverride>> overrides_;  // by edge
};

}  // namespace streetgen
