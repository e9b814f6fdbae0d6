// Junctions: nodes that traffic meets as one place.  Wilkie, Sewall and Lin, section 4.3.
//
// The paper collapses an edge whose two offsets leave nothing of it.  Here nothing is collapsed:
// nodes are grouped above the network.  docs/guide/junctions.md draws each rule.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "streetgen/control_point.hpp"
#include "streetgen/geometry.hpp"

namespace streetgen {

// An edge, as far as the rules of junctions ask for it.
struct JunctionEdge {
  std::int64_t axis_id = 0;
  double start_abscissa = 0, end_abscissa = 0;  // metres along its axis
  int from_node = 0;                            // index into JunctionNetwork::nodes
  int to_node = 0;
  Line line;          // from its first to its last node, at least two distinct points
  bool along = true;  // whether traffic runs from its first to its last node
  bool against = true;
  std::int64_t name = 0;          // equal for edges of one street; 0: unknown
  bool crossed = false;           // its section limits crossed: its intersections touch
  bool on_ring = false;           // of a roundabout
  std::optional<bool> by_hand{};  // inside its junction, or not, whatever the rules say
  int importance = 99;
  double width = 0, width_end = 0;  // metres, at its two nodes
};

struct JunctionNetwork {
  std::vector<Point> nodes;
  std::vector<JunctionEdge> edges;
  std::vector<ControlPoint> controls;
};

// Metres.
struct JunctionRules {
  double gap = 35;     // longest link between the two carriageways of a street
  double extent = 80;  // a junction by such links is no wider
  ControlRules controls{};
};

enum class EdgeRole { outside, inside, slip_lane };
const char* edge_role_name(EdgeRole role) noexcept;

struct JunctionGroups {
  std::vector<int> of_node;  // by node: the first node of its junction
  // By node: the first node of those that the rules would join, whether the extent allows that or
  // not.  A junction is a function of the edges at these nodes.
  std::vector<int> chain_of_node;
  std::vector<EdgeRole> roles;  // by edge
  std::vector<bool> parted;     // by edge: a rule would join its nodes, but the extent forbids that
  // By slot, 2 * edge and 2 * edge + 1: of the control points that speak to the traffic which comes
  // to a node by that end, the strictest.
  std::vector<std::optional<ControlKind>> controls;
  std::vector<int> served;  // by control point: a node that it speaks at, -1: none
};

// One junction are
//   the two nodes of an edge whose limits crossed, and of one that is inside by hand;
//   the nodes of a link of no more than `gap` between the carriageways of a street: an edge, or
//     several that go on from each other at nodes of two.  At its ends one-way edges lie across the
//     link, of opposite directions.  They have one name; or a name is unknown, both go through
//     within 30 degrees, and to one side of the link both are twice as long as it is;
//   the two ends of a slip lane, and the corner that it cuts.  A slip lane is a one-way edge or
//     chain of edges of no more than `extent`, from before the corner to another street behind it;
//   the nodes of a way between two with signals on which a queue has no room.
// The last three join, those between signals first, then from the shortest on, and only what then
// lies within `extent`, not counting what is joined by hand.  The first is never parted.  An edge
// that by hand is not inside joins nothing.  An edge of a roundabout is no link and no slip lane.
// Independent of the order of nodes and edges, but for `of_node`.
JunctionGroups group_junctions(const JunctionNetwork& network, const JunctionRules& rules);

}  // namespace streetgen
