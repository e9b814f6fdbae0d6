// Rings of a network that may be roundabouts, and what tells them from blocks.  StreetGen paper,
// section 2.8.
#pragma once

#include <cstdint>
#include <vector>

#include "streetgen/control_point.hpp"
#include "streetgen/geometry.hpp"
#include "streetgen/network.hpp"

namespace streetgen {

enum class OneWay {
  no,
  along,
  against
};  // in the direction of the axis; no: unknown, or both ways

struct RingAxis {
  std::int64_t axis_id = 0;
  Line line;
  int level = 0;
  OneWay one_way = OneWay::no;
  bool tagged = false;  // a source says that it is part of a roundabout
  // These are those of a StreetAxis, by which an axis that lies on another has no edge, and by
  // which signals in mid-block cut one.
  double width = 0, width_end = 0, roadway_offset = 0;
  int importance = 99;
  bool leads_forward = true, leads_backward = true;
  std::vector<ControlPoint> controls{};
};

struct RingSettings {
  double tolerance = 0.5;  // metres, of the network
  Crossing crossing = Crossing::over;
  // The circle fitted to a ring, metres, unless it is tagged; the smallest circle about it is no
  // greater than the second.
  double radius_least = 3, radius_greatest = 60;
  double shape_least = 0.5;       // a ring of less compactness is none, unless it is tagged
  bool counter_clockwise = true;  // traffic goes round so: one drives on the right
  ControlRules controls{};
};

// An edge of a ring, or of what meets it, named by its axis and place.
struct RingEdge {
  std::int64_t axis_id = 0;
  double start_abscissa = 0, end_abscissa = 0;  // metres along the axis
  // The ring: whether traffic that goes round drives along the axis.  An arm: whether traffic
  // that comes to the ring does.
  bool along_axis = true;
  int face = 1;  // of the ring, whose face of that number it bounds
};

// A closed way of edges within the bounds of radius and shape, with no edge between it and the
// ground within.  What hangs into that ground is left out, and what crosses without a node, above
// or below, parts nothing.  Where a way hangs there that leaves it again so, there is no ring: what
// is one depends on nothing beyond the smallest circle about it, but for what a double one needs.
// A closed way of tagged edges is a ring whatever lies within: a street through its middle has two
// arms of it there. Nothing else is a ring along its inner side.
// Edges may lie on several levels, as those of a ring over a motorway.
// A double roundabout is one ring of two faces.  Both are nearly circles: compactness of 0.9, one
// radius at most twice the other.  They share one piece of way, fit into half of the greatest
// circle, and neither has another such neighbour.  Their shape is that of the less round one; so is
// that of a peanut, whose narrowest place parts two such halves.
struct NetworkRing {
  int level = 0;                // on which the most of the line lies, the lower one of two alike
  std::vector<RingEdge> edges;  // face by face, counter-clockwise from its smallest place on
  std::vector<RingEdge> arms;   // edges that leave it, in the same order
  std::vector<Ring> faces;      // counter-clockwise, closed; two of a double roundabout
  Ring line;                    // about all of them
  bool waist = false;           // a peanut: its halves are rounder than the whole
  Point centre;                 // of the circle of least squares of this line
  double radius = 0;            // metres
  double on_circle = 0;         // share of its line within a tenth of the radius of its circle
  double compactness = 0;  // area by that of the circle of the same length, as Polsby and Popper
  double one_way = 0;      // share of the line whose traffic goes round, and of that
  double against = 0;      // which goes the other way
  double single_arm = 0;   // share of the nodes with arms that have one arm
  int arm_nodes = 0;       // nodes with arms
  int inside = 0;          // nodes of its level within, and loops that hang on the ring there
};

// The tagged ones come first, then all others.  Of each, rings of one level come first, level by
// level in the order of smallest places; rings whose edges lie on several levels follow.
// Deterministic, and independent of the order of the axes.  The edges are those of
// streetgen::street_network with the same axes.
std::vector<NetworkRing> network_rings(const std::vector<RingAxis>& axes,
                                       const RingSettings& settings);

}  // namespace streetgen
