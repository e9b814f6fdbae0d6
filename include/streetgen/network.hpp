// The network: axes snapped together and cut at the points that they share.
//
// Ends and vertices within `tolerance` (metres, planar) of each other join
// transitively, whatever the order of the axes; a cluster wider than three
// tolerances, by the circle about it, is reported and not joined.  A node lies
// where most arms of what joins meet: a vertex inside an axis has two, an end has
// one, a split crossing without a vertex has four.  Of several such places it is
// the middle, each counted once.  An axis end within tolerance of the inside of
// another axis' segment makes a node at that end.  Nodes within tolerance of each
// other along an axis are one, in the same way and within the same bound.  A
// crossing within tolerance of a node along one of its axes is that node.
// Levels that differ meet only where the point is an end of at least one axis;
// where it is interior to all, they pass over each other and make no node.  No
// vertex that another axis shares is removed.
#pragma once

#include <cstdint>
#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

// Two axes of one level that cross without a vertex do so.
enum class Crossing {
  over,   // no node; reported
  split,  // a node where they cross; none is reported
};

struct NetworkAxis {
  std::int64_t axis_id = 0;
  Line line;  // at least two distinct points, finite
  int level = 0;
};

// The way back from a node to its input: one axis end or shared vertex.
struct NodeAnchor {
  std::int64_t axis_id = 0;
  double abscissa = 0;  // metres along the input axis
};

struct Node {
  Point point;
  std::vector<NodeAnchor> anchors;  // sorted by (axis_id, abscissa); never empty
};

// A piece of an axis between two nodes, snapped to them, in the direction of the axis.
struct Edge {
  std::int64_t axis_id = 0;
  int from_node = 0;  // index into Network::nodes
  int to_node = 0;    // equal to from_node for a loop
  int level = 0;
  double start_abscissa = 0;  // metres along the input axis
  double end_abscissa = 0;
  Line line;  // starts at from_node's point, ends at to_node's; at least two distinct points
  CurvedLine curve{};  // the arc road of which the line is chords; empty where there is none
};

// The end of an edge that touches a node.
struct EdgeEnd {
  int edge = 0;
  bool at_start = true;
};
inline int slot(const EdgeEnd& end) { return 2 * end.edge + (end.at_start ? 0 : 1); }

// One side of an edge. Where another edge of its level crosses or touches it without a node, each
// side has several parts, from 1 in the direction of the edge.
struct EdgeSide {
  int edge = 0;      // index into Network::edges
  bool left = true;  // in the direction of the edge
  int part = 1;
  double start = 0, end = 0;  // of the part, metres along the edge, to the millimetre
};

enum class NetworkIssue {
  wide_cluster,    // points or nodes chain wider than three tolerances: not joined
  crossing,        // two axes of one level cross without a vertex (split or passed over)
  collapsed_axis,  // an axis shorter than the tolerance, or whose ends join: it has no edge
  // Of streets alone, street_network.hpp:
  lies_on_another,  // a stretch of an axis that lies on another one
  misses,           // an end in the roadway of another one, without a node
};

struct NetworkReport {
  NetworkIssue issue;
  std::int64_t axis_a = 0;
  std::int64_t axis_b = 0;  // equal to axis_a where only one is concerned
  Point point;
  // Metres: width of the cluster, length of the axis or stretch, or from the end to the other axis.
  double measure = 0;
};

struct Network {
  std::vector<Node> nodes;  // sorted by their smallest (axis_id, abscissa)
  std::vector<Edge> edges;  // sorted by (axis_id, start_abscissa)
  std::vector<NetworkReport> reports;
};

// Deterministic and independent of the order of `axes` (axis ids are distinct).
// tolerance > 0, metres.  A loop (both ends of an axis at one node) is one edge.
// A closed axis met by nothing is one loop edge at its start.
Network network(const std::vector<NetworkAxis>& axes, double tolerance, Crossing crossing);

}  // namespace streetgen
