// The alignment of a road in height: straight grades and parabolas between them.
//
// A grade point is a vertex of the straight grades. Its parabola has radius R (metres) and length
// R |g2 - g1| for the grades g1 and g2 (rise over run) that meet there, half of it on each side.
#pragma once

#include <vector>

namespace streetgen {

struct GradePoint {
  double abscissa = 0, height = 0;  // metres
  double radius = 0;                // metres; 0: the grades meet in a corner
};

// A straight grade or a parabola: height(t) = height + grade t + bend t^2 / 2, t metres on.
struct GradePiece {
  double start_abscissa = 0, end_abscissa = 0;
  double height = 0, grade = 0;  // at the start
  double bend = 0;               // 1 / radius, positive in sags, negative on crests; 0: straight
};

// The pieces in order. Refused (invalid_input): abscissas out of order, radii below 0, parabolas
// that overlap. Points count from 1. One point gives no piece.
std::vector<GradePiece> vertical_alignment(const std::vector<GradePoint>& points);

// Height and grade at an abscissa; the first and the last grade go on beyond the ends.
struct GradePlace {
  double height = 0, grade = 0;
};
GradePlace grade_place(const std::vector<GradePiece>& pieces, double abscissa);

}  // namespace streetgen
