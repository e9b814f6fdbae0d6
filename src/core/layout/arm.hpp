// The streets about a node: one arm for each edge end, one gap between neighbouring arms.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "streetgen/corner.hpp"
#include "streetgen/geometry.hpp"
#include "streetgen/ramp.hpp"
#include "streetgen/width_profile.hpp"

namespace streetgen {

// One end of an edge at a node, seen from the node.
struct Arm {
  Line line;              // starts at the node
  double half_start = 0;  // half widths, metres, linear along the line
  double half_end = 0;
  double limit = 0;  // abscissa where the intersection ends
  double askew = 0;  // metres that it ends farther out on the left kerb, and nearer on the right
  double asked_left = 0, asked_right = 0;  // abscissas up to which the corners on each side reach
  Line border{};                           // at the limit: left and right kerb, seen from the node
  double widest = 0;          // metres, of what a change of width adds within the section
  double roadway_offset = 0;  // metres from the line to the middle of the roadway, left positive
  std::vector<MergingStretch> merging{};  // seen from the node

  // Where the intersection ends on the kerb of a side.
  double limit_on(int side) const { return limit + side * askew; }
  // From the line to the kerb on one side, metres; +1: left, seen from the node, -1: right.
  double start_to(int side) const {
    return half_start + side * roadway_offset + merging_at(0, side);
  }
  double end_to(int side) const;
  // What merging lanes add on a side, metres.
  double merging_at(double abscissa, int side) const {
    double added = 0;
    for (const MergingStretch& stretch : merging)
      if (stretch.side == side) added += stretch.width_at(abscissa);
    return added;
  }
  // The farthest kerb.
  double reach() const;
};

// A kerb that goes on through the node with another width: linear about the node, as wide as its
// arms beyond, and nowhere within the kerb of a third arm. Straight on from the wider one, which
// keeps its width up to the node.
struct Taper {
  double reach_a = 0, reach_b = 0;  // metres from the node to its ends, along both arms
  double half_a = 0, half_b = 0;    // from the lines to the kerb there
  bool straight_on = false;
  double least_at_node = 0;  // to the kerb of a third arm beside one of them

  double length() const { return reach_a + reach_b; }
  double half_at_node() const {
    const double between = half_a + (half_b - half_a) * reach_a / length();
    return std::max(least_at_node, straight_on ? std::max(half_a, half_b) : between);
  }
  double half_on_a(double abscissa) const { return half_on(reach_a, half_a, abscissa); }
  double half_on_b(double abscissa) const { return half_on(reach_b, half_b, abscissa); }

 private:
  double half_on(double reach, double half, double abscissa) const {
    const double at_node = half_at_node();
    return reach > 0 ? at_node + (half - at_node) * abscissa / reach : at_node;
  }
};

// Between arm i and the next one counter-clockwise.
struct Gap {
  bool meets = false;  // the borders meet (an arc, or their crossing where radius is 0)
  CornerArc corner;
  double angle = 0;     // counter-clockwise about the node, radians; over pi outside a bend
  bool sharp = false;   // no arc is wanted
  bool tapers = false;  // the kerb goes on through the node as the width changes
  Taper taper{};        // where it tapers, once limits are settled
  bool direct = false;  // it tapers straight from limit to limit
  Polygon beyond{};     // the ground between both kerbs and an arc that lies beyond an arm's end
  // Where the kerbs cross, of a corner whose limits lie before that place.
  std::optional<CornerArc> crossing{};
  // Between both sections, once such limits are settled: from the crossing of the border lines by
  // that of the kerbs to a vertex of the arc.
  Line parting{};
};

// From the line to the kerb on one side.
double half_at(const Arm& arm, double abscissa, int side);
// The same at the arm's start and end, if it changed as it does between two abscissas.
std::pair<double, double> halves(const Arm& arm, double u, double v, int side);
// From the line to the kerb on the side of a place, at the arm's start.
double half_towards(const Arm& arm, const Point& place);
// Whether an arm goes on as the other with both kerbs in one line.
bool as_wide(const Arm& a, const Arm& b);
// The line between two abscissas, planar, with a point at each place of a profile.
Line line_with_places(const Arm& arm, const WidthProfile& profile, double start, double end);
// Whether streets that leave their node at this angle go on as each other, within 20 degrees.
bool nearly_in_line(double angle);
// Left and right kerb at `abscissa`, across the local direction.
Line border_across(const Arm& arm, double abscissa);

}  // namespace streetgen
