// Rings put together piece by piece, and what holds when that fails.
#pragma once

#include <vector>

#include "course.hpp"
#include "geos.hpp"
#include "streetgen/geometry.hpp"

namespace streetgen {

constexpr double same_place = 1e-6;  // metres: nearer, a point was only made in two ways

// Metres; half widths that differ by less go on as one street.
constexpr double same_width = 0.005;

// One end of an edge at a node, seen from the node.
struct Arm {
  Line line;              // starts at the node
  double half_start = 0;  // half widths, metres, linear along the line
  double half_end = 0;
  double limit = 0;  // abscissa where the intersection ends
  Line border;       // at the limit: left and right kerb, seen from the node
};

// Between arm i and the next one counter-clockwise.
struct Gap {
  bool meets = false;  // the borders meet (an arc, or their crossing where radius is 0)
  CornerArc corner;
  double angle = 0;  // counter-clockwise about the node, radians; over pi outside a bend
  Polygon beyond{};  // the ground between both kerbs and an arc that lies beyond an arm's end
};

double half_at(const Arm& arm, double abscissa);
// Left and right kerb at `abscissa`, across the local direction.
Line border_across(const Arm& arm, double abscissa);

// Between the kerbs that leave `crossing` (left of a, right of b) and the arc of `corner`.
Polygon cusp(const Course& a, const Course& b, const CornerArc& crossing, const CornerArc& corner);

// Without repeated points; empty when fewer than three remain.
Ring closed(Ring ring);

struct Built {
  MultiPolygon surface;
  bool by_union = false;
};

// The part of one axis between two abscissas; its ends are the given borders (left, right).
Built build_section(Geos& geos, const Arm& arm, double start, double end, const Line& start_border,
                    const Line& end_border);

// gaps[i] lies between arms[i] and arms[i + 1], arms counter-clockwise.
Built build_intersection(Geos& geos, const std::vector<Arm>& arms, const std::vector<Gap>& gaps);

// The union of quads, bends and discs: holds for any line.
MultiPolygon build_buffer(Geos& geos, const Line& line, const std::vector<double>& left,
                          const std::vector<double>& right, bool round_ends);

// The same with flat ends: the given borders (left, right along the line).
MultiPolygon build_between(Geos& geos, const Line& line, const std::vector<double>& left,
                           const std::vector<double>& right, const Line& from, const Line& to);

}  // namespace streetgen
