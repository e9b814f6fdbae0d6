// Roads: maximal chains of edges that go on through nodes where two edges meet. Wilkie, Sewall and
// Lin, "Transforming GIS Data into Functional Road Models for Large-Scale Traffic Simulation", 4.1.
#pragma once

#include <cstdint>
#include <vector>

#include "streetgen/geometry.hpp"
#include "streetgen/network.hpp"

namespace streetgen {

// By hand: the radius of a bend, metres; 0: it stays sharp. The bend is the inner point of an edge
// that is nearest to the place, within a metre along the axis. One that does not fit becomes the
// greatest that does; of two beside each other both shrink by the same share. One without its bend
// changes nothing; of two for one bend the later holds.
struct RoadOverride {
  std::int64_t axis_id = 0;
  double abscissa = 0;  // metres along the axis
  double radius = 0;
};

struct RoadMember {
  int edge = 0;
  bool along = true;          // whether the edge runs along the road
  double start_abscissa = 0;  // metres along the road, where the edge begins
};

// A road runs along the first of its edges in the order of the network, and a closed one starts
// there.
struct Road {
  int from_node = 0, to_node = 0;
  bool closed = false;  // a ring of nodes of degree two
  double length = 0;    // of its edges, along their axes
  std::vector<RoadMember> members;
  CurvedLine curve;  // the arc roads of its edges
};

// The roads of a network, in the order of their first edges. A node counts ends of edges: a loop
// has two. `branching` (by node; empty: none) says where edges meet that are not given: roads end
// there. An edge without a curve gets its arc road here, which leaves the polyline by at most
// `shift` metres. Every edge is in one road, so that
//   roads = edges - nodes of degree two + closed roads.
std::vector<Road> roads(const Network& network, const std::vector<bool>& branching, double shift,
                        const std::vector<RoadOverride>& overrides);

}  // namespace streetgen
