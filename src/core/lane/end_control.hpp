// The control point that speaks to the traffic that comes to a node by an edge.
#pragma once

#include <optional>
#include <vector>

#include "network/control_reach.hpp"
#include "streetgen/control_point.hpp"
#include "streetgen/lane.hpp"
#include "streetgen/network.hpp"

namespace streetgen {

// Traffic that comes to a node by one end of an edge.
struct EndControl {
  std::optional<ControlKind> own;         // of its control points, that of the highest rank
  std::optional<ControlKind> at_node;     // the highest of all ends at the node
  std::optional<JunctionKind> decided{};  // what the node is by hand
  bool waits = false;   // by rank among equals, where important streets meet or streets merge
  bool within = false;  // it comes from signals so near that it has waited there already

  // Whether traffic waits for signals: who decides that it waits by a rule leaves none.
  bool at_signals() const {
    const bool by_rule = decided == JunctionKind::stop || decided == JunctionKind::priority ||
                         decided == JunctionKind::right_before_left;
    return decided == JunctionKind::signals || (at_node == ControlKind::signals && !by_rule);
  }
};

// What the rules of control points ask of an edge.
struct ControlEdge {
  EdgeWays ways{};
  int importance = 99;
  double width = 0, width_end = 0;  // metres
  Point from_start{}, from_end{};   // unit directions in which it leaves its two nodes
};

ControlEdge control_edge(const EdgeWays& ways, int importance, double width, double width_end,
                         const Line& line);

struct EndControls {
  std::vector<EndControl> ends;  // by slot: 2 * edge, 2 * edge + 1
  // By control point: a node that it speaks at, -1: none.
  std::vector<int> served;
};

// Each control point speaks to the ends that ControlReach says, signals in mid-block to both ends
// at the node that they stand on.  Of several for one end signals come first, then stop, yield,
// pedestrian crossing.  A stop or yield sign on a junction's own node binds the arms that wait for
// others, unless it speaks to both directions.  A decision holds for the nearest node of its axis,
// as far as `farthest` metres off; of two for one node the later.  `edges` by edge of the network.
EndControls end_controls(const Network& network, const std::vector<ControlEdge>& edges,
                         const std::vector<ControlPoint>& points, const ControlRules& rules,
                         const std::vector<JunctionDecision>& decisions = {});

// The control points, and a yield sign on each end of an edge that comes from the side to one that
// the source says is on a roundabout.
std::vector<ControlPoint> with_ring_entries(const Network& network,
                                            const std::vector<LanesOfAxis>& lanes,
                                            std::vector<ControlPoint> points);

}  // namespace streetgen
