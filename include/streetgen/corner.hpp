// Corners between two axes that start at a common node.  StreetGen paper, 2.4.
//
// Both axes start at the node; the corner lies counter-clockwise from a to b: it
// touches the left border of a and the right border of b.  Widths are kerb to kerb,
// lengths metres.  Axes are polylines of at least two distinct, finite points.
#pragma once

#include <optional>

#include "streetgen/geometry.hpp"

namespace streetgen {

struct CornerArc {
  Point centre;
  double radius = 0;
  Arc arc;                // from the left border of a to the right border of b
  double abscissa_a = 0;  // of the centre's closest point on a, metres from the node; negative
                          // where a roadway beside its axis has its corner behind the node
  double abscissa_b = 0;
};

// The circle of `radius` outside both axes' borders, the first on the way out from the node along
// both among all places at width / 2 + radius of both (curves of the offset borders included); of
// two as far the nearer to the node.  An axis that comes back to its node counts up to half its
// length.  None where the offset borders do not meet.
std::optional<CornerArc> corner_arc(const Line& axis_a, const Line& axis_b, double width_a,
                                    double width_b, double radius);

// The same of axes that begin behind their node, out from that node both ways.
std::optional<CornerArc> corner_arc(const Line& axis_a, const Line& axis_b, double width_a,
                                    double width_b, double radius, const Point& node);

// The centre of that circle.
std::optional<Point> arc_centre(const Line& axis_a, const Line& axis_b, double width_a,
                                double width_b, double radius);

// The largest radius (up to `radius_limit`) whose arc still touches both axes within
// their lengths, to 1e-6 m; none where not even radius 0 does.
std::optional<double> max_corner_radius(const Line& axis_a, const Line& axis_b, double width_a,
                                        double width_b, double radius_limit = 1000);

// Equation 1 of the paper ("paper") or the exact law it comes from ("setra"), clamped to
// [minimal, maximal] m.  speed km/h; width metres, kerb to kerb.
double turning_radius(double speed, double width, const char* mode, double minimal = 0.15,
                      double maximal = 15);

}  // namespace streetgen
