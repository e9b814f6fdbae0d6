// Paths across a junction of several nodes: each turn as one smooth path, lane to lane.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "streetgen/geometry.hpp"
#include "streetgen/interconnection.hpp"
#include "streetgen/lane.hpp"

namespace streetgen {

// An end of an edge that leaves the junction.
struct JunctionLeg {
  std::int64_t axis_id = 0;
  int edge = 0;  // tells the two ends of one edge from those of others
  int node = 0;  // index into JunctionPlace::nodes
  int importance = 99;
  double speed = 50;     // km/h
  bool on_ring = false;  // traffic on it goes round a roundabout: from and to there none turns back
  Line border_line;      // of the section limit at this end: two points
};

// A lane that comes in or goes out by a leg; one for both directions does both, as two rows.
struct JunctionLane {
  std::int64_t lane_id = 0;
  int leg = 0;
  bool comes_in = true;
  bool along_axis = true;  // whether its traffic runs along the axis
  LaneKind kind = LaneKind::general;
  unsigned turns = 0;
  Line line;  // in the direction of its traffic
};

// An edge inside the junction.
struct InnerEdge {
  std::int64_t axis_id = 0;
  int edge = 0;  // tells it from other edges, as JunctionLeg::edge does
  int from_node = 0, to_node = 0;
  LaneKinds along, against;           // whose lanes lead along its line, and against it
  double offset_along = 0;            // of that traffic's lanes, metres to the left of the line
  double offset_against = 0;
  Line line;
};

// A path at one node, from lane to lane.
struct LaneStep {
  std::int64_t interconnection_id = 0;
  std::int64_t lane_in = 0, lane_out = 0;
  bool along_in = true, along_out = true;
  bool plausible = true;
};

// A restriction of the traffic that comes by one axis, passes the edges `via` in their order, and
// goes on by another axis.  Other edges may lie between these.
struct WayRestriction {
  std::int64_t from_axis = 0;
  std::int64_t to_axis = 0;
  std::vector<int> via;  // InnerEdge::edge
  bool only = false;     // the only way on, wherever the next of these begins; else: no way
  std::vector<LaneKind> except{};  // it does not bind traffic of these kinds, on whatever lane
};

struct JunctionPlace {
  std::vector<Point> nodes;
  std::vector<JunctionLeg> legs;
  std::vector<JunctionLane> lanes;  // of each leg from left to right in their driving direction
  std::vector<InnerEdge> inner;
  std::vector<LaneStep> steps;
  std::vector<TurnRestriction> restrictions;
  std::vector<WayRestriction> way_restrictions;
  MultiPolygon surface;
};

struct JunctionMovement {
  int lane_in = 0, lane_out = 0;  // indices into JunctionPlace::lanes
  Turn turn = Turn::through;
  double angle = 0;  // degrees in (-180, 180] from lane to lane, positive to the left
  bool plausible = false;
  Reason reason = Reason::lane_order;
  LaneKinds traffic{};  // who may take it, by the kinds of lanes; general: all
  std::vector<std::int64_t> interconnections;  // of the lanes on the way; empty: none lead there
  Line line;
};

// Every lane that comes in with every lane that goes out by another leg, where the edges inside
// lead from the one to the other in their directions.  A pair whose every such way is forbidden by
// restrictions, at a node or via edges, is there, and not plausible.  Paths are tangent to both
// lanes and go clear of the kerbs of `surface` where a path does; the rules of plausible pairs are
// those of one node.  More pairs than settings.most: none are made.  By (lane_in, lane_out).
std::vector<JunctionMovement> junction_movements(const JunctionPlace& place,
                                                 const InterconnectionSettings& settings);

}  // namespace streetgen
