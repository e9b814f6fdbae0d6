// The control point that speaks to the traffic that comes to a node by an edge.
#pragma once

#include <optional>
#include <vector>

#include "streetgen/control_point.hpp"
#include "streetgen/lane.hpp"
#include "streetgen/network.hpp"

namespace streetgen {

// Traffic that comes to a node by one end of an edge.
struct EndControl {
  std::optional<ControlKind> own;         // of its control points, that of the highest rank
  std::optional<ControlKind> at_node;     // the highest of all ends at the node
  std::optional<JunctionKind> decided{};  // what the node is by hand

  // Whether traffic waits for signals: who decides that it waits by a rule leaves none.
  bool at_signals() const {
    const bool by_rule = decided == JunctionKind::stop || decided == JunctionKind::priority ||
                         decided == JunctionKind::right_before_left;
    return decided == JunctionKind::signals || (at_node == ControlKind::signals && !by_rule);
  }
};

// Each control point belongs to the next node of three and more edges ahead of it on its edge, as
// far as `farthest` metres before the node; one farther off stands in the middle of its block.  Of
// several for one end signals come first, then stop, yield, pedestrian crossing.  One on a node of
// two edges belongs to that node.  One beyond its axis, or on an axis without an edge there,
// changes nothing.  A decision holds for the nearest node of its axis, as far as `farthest` metres
// off; of two for one node the later.  By slot: 2 * edge, 2 * edge + 1.
std::vector<EndControl> end_controls(const Network& network, const std::vector<LanesOfAxis>& lanes,
                                     const std::vector<ControlPoint>& points, double farthest,
                                     const std::vector<JunctionDecision>& decisions = {});

// The control points, and a yield sign on each end of an edge that comes from the side to one that
// the source says is on a roundabout.
std::vector<ControlPoint> with_ring_entries(const Network& network,
                                            const std::vector<LanesOfAxis>& lanes,
                                            std::vector<ControlPoint> points);

}  // namespace streetgen
