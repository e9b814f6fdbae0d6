// The legs of a node, with their lanes, and the movements from leg to leg.
#pragma once

#include <vector>

#include "streetgen/geometry.hpp"
#include "streetgen/interconnection.hpp"

namespace streetgen {

// The place where a lane touches the intersection, and its driving direction there.
struct LaneEnd {
  LaneKind kind = LaneKind::general;
  unsigned turns = 0;
  Point place;
  Point direction;
  double aside = 0;     // metres from the node, to the left as one drives
  bool middle = false;  // of both directions, for those who turn off
  unsigned ahead = 0;   // of a lane out: the ways that it serves at a next junction too near to
                        // change lanes before it, a bit each
};

// An end of an edge at the node; lanes from left to right in their driving direction.
struct Leg {
  std::vector<LaneEnd> in, out;
  Point outset;  // unit: of its street at the node
  Point course;  // unit: from the node to where its street is clear of it
  Point stand;   // there
  int importance = 99;
  bool on_ring = false;  // traffic on it goes round a roundabout: from and to there none turns back
};

struct Verdict {
  bool plausible = false;
  Reason reason = Reason::lane_order;
  LaneKinds traffic{};  // of reason traffic: who alone takes it
};

// Who may go from a lane to a lane: all whom the lanes let in, or of these those alone that the
// verdict lets.
LaneKinds traffic_of(const Verdict& verdict, LaneKind in, LaneKind out);

// From a leg to another (or back): a verdict for each pair, lanes in by lanes out.
struct Movement {
  int from = 0;  // index of the leg
  int to = 0;
  bool turns_back = false;  // into its own street, where none means to let it
  LaneKinds restricted;     // forbidden to lanes in of these kinds, unless to a lane out of another
  double least_radius = 0;  // metres, what the speed needs
  std::vector<double> radius;  // of the trajectory of each pair
  std::vector<bool> drivable;  // by pair: the trajectory has no corner
  std::vector<Verdict> verdicts;
  // Known of a ramp: it lies left (+1) or right (-1) of the highway with its traffic.
  int side = 0;

  bool forbidden(LaneKind in) const { return restricted[index_of(in)]; }
  bool forbidden(LaneKind in, LaneKind out) const { return forbidden(in) && forbidden(out); }
};

}  // namespace streetgen
