// What the steps from axes to surfaces share: the network, the arms about its nodes, and the rows
// that come about.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "layout/surface_ring.hpp"
#include "streetgen/street.hpp"

namespace streetgen {

// What meets at a node.
struct Junction {
  std::vector<EdgeEnd> ends;             // counter-clockwise
  std::vector<Gap> gaps;                 // between ends[i] and ends[i + 1]; none at a dead end
  std::optional<Transition> transition;  // its length is known
  bool transition_yields = false;        // to the limits at the far ends of its edges
  int along = 0;              // index in ends: the axis that the transition is seen along
  bool straight = false;      // two edges go on so straight that nothing lies between them
  std::vector<int> followed;  // further nodes that a corner looked at
  int ramp = -1;              // its place in Streets::ramps; -1: it is none

  const EdgeEnd& next(std::size_t i) const { return ends[(i + 1) % ends.size()]; }
  bool dead_end() const { return ends.size() == 1; }
  // Index of the end from which sides of the transition are seen: an axis that starts at the node
  // goes on from it.
  int transition_from() const { return ends[along].at_start ? 1 - along : along; }
};

// Edges of a highway in a row, over nodes that only join two of them, along which the merging lanes
// of the ramps at its ends lie.
struct MergingRun {
  std::vector<EdgeEnd> edges;           // each by the end that comes first
  int first_ramp = -1, last_ramp = -1;  // in Streets::ramps, at the ends of the run; -1: none
};

struct Layout {
  Layout(const std::vector<StreetAxis>& axes, const StreetSettings& settings,
         const std::vector<RoadOverride>& overrides);

  const StreetAxis& axis_of(int edge) const { return *axes[edge]; }
  const Arm& arm(const EdgeEnd& end) const { return arms[slot(end)]; }
  Arm& arm(const EdgeEnd& end) { return arms[slot(end)]; }
  const Junction& junction_of(const EdgeEnd& end) const {
    const Edge& edge = streets.network.edges[end.edge];
    return junctions[end.at_start ? edge.from_node : edge.to_node];
  }
  std::vector<Arm> arms_of(int node) const;
  // The level with most of the node's edges; ties: the lowest.
  int level_of(int node) const;
  // Whether no edge of the node lies within reach of the change.
  bool outer(int node) const;
  // Whether one does not.
  bool meets_outer(int node) const;

  const StreetSettings& settings;
  Streets streets;
  std::vector<const StreetAxis*> axes;     // by edge
  std::vector<std::int64_t> axis_lengths;  // by edge, millimetres
  std::vector<Arm> arms;                   // by slot
  std::vector<Junction> junctions;         // by node
  std::vector<MergingRun> merging_runs;

 private:
  void add_arms(int edge);
  void sort_ends();
};

}  // namespace streetgen
