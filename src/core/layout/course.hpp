// A street as a corner sees it: along the axes that go on from one another.
#pragma once

#include <optional>
#include <vector>

#include "geometry/offset.hpp"
#include "layout/arm.hpp"
#include "streetgen/corner.hpp"

namespace streetgen {

// A line with its distance from the kerb of one side; where the width changes, that kerb, with
// none.
struct CoursePiece {
  Line line;
  double half = 0;            // metres
  double start = 0, end = 0;  // abscissas on the course
};

using Course = std::vector<CoursePiece>;  // starts at the node

// Of an arm alone, as wide on one side as at its node.
Course course_of(const Arm& arm, int side);
inline const Course& course_of(const Course& course, int) { return course; }

// As of two axes: the left border of a, the right one of b.
std::optional<CornerArc> corner_arc(const Course& a, const Course& b, double radius);
std::optional<double> max_corner_radius(const Course& a, const Course& b, double radius_limit);

// The line as far as an abscissa.
Line walked(const Course& course, double until);
// Where the line goes at an abscissa.
Point direction_at(const Course& course, double abscissa);

// The kerb between two abscissas, backwards when u > v.
KerbLine kerb_line(const Course& course, double u, double v, int side);

}  // namespace streetgen
