// Rings of a network that may be roundabouts, and what tells them from blocks.  StreetGen paper,
// section 2.8.
#pragma once

#include <cstdint>
#include <vector>

#include "streetgen/geometry.hpp"
#include "streetgen/network.hpp"

namespace streetgen {

enum class OneWay { no, along, against };  // in the direction of the axis; no: unknown, or both ways

struct RingAxis {
  std::int64_t axis_id = 0;
  Line line;
  int level = 0;
  OneWay one_way = OneWay::no;
};

struct RingSettings {
  double tolerance = 0.5;  // metres, of the network
  Crossing crossing = Crossing::over;
  // Of the circle fitted to a ring, metres; the smallest circle about it is no greater than the
  // second.
  double radius_least = 3, radius_greatest = 60;
  double shape_least = 0.4;       // a ring whose area is a smaller share of that circle's is none
  bool counter_clockwise = true;  // traffic goes round so: one drives on the right
};

// An edge of a ring, or of what meets it, named by its axis and place.
struct RingEdge {
  std::int64_t axis_id = 0;
  double start_abscissa = 0, end_abscissa = 0;  // metres along the axis
  // Of the ring: whether traffic that goes round drives along the axis.  Of an arm: whether traffic
  // that comes to the ring does.
  bool along_axis = true;
};

// A face of the network within the bounds of radius and shape.  What hangs into it is left out.
struct NetworkRing {
  int level = 0;
  std::vector<RingEdge> edges;  // counter-clockwise, from the smallest place of the face on
  std::vector<RingEdge> arms;   // edges that leave it outwards, in the same order
  Ring line;                    // counter-clockwise, closed
  Point centre;                 // of the circle of least squares
  double radius = 0;            // metres
  double on_circle = 0;         // share of the line within a tenth of the radius of this circle
  double fill = 0;              // area by that of the smallest circle about it
  double one_way = 0;           // share of the line whose traffic goes round, and of that
  double against = 0;           // which goes the other way
  double single_arm = 0;        // share of the nodes with arms that have one arm
  int arm_nodes = 0;            // nodes with arms
  int inside = 0;               // edges that hang into the face, and islands of edges within it
};

// In the order of level, then of the smallest places.  Deterministic, and independent of the order
// of the axes.  The edges are those of streetgen::network with the same axes.
std::vector<NetworkRing> network_rings(const std::vector<RingAxis>& axes,
                                       const RingSettings& settings);

}  // namespace streetgen
