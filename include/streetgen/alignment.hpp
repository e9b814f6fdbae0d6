// The alignment of a road in the plan: straight lines, clothoids and arcs that follow each other
// without a jump of position, heading or curvature.
//
// A clothoid has curvature that is linear in its length. Its parameter A (metres) says how fast:
// length = A^2 / radius from a straight line to an arc of that radius. Abscissas are metres along
// the alignment. Headings are radians counter-clockwise from the x axis, curvatures 1/m, positive
// on left bends. Errors are of kind invalid_input and count points from 1.
#pragma once

#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

enum class ElementKind { line, clothoid, arc };

struct AlignmentElement {
  double abscissa = 0;
  Point start;
  double heading = 0;  // at the start
  double length = 0;
  double curvature_start = 0, curvature_end = 0;

  ElementKind kind() const {
    if (curvature_start != curvature_end) return ElementKind::clothoid;
    return curvature_start == 0 ? ElementKind::line : ElementKind::arc;
  }
};

struct AlignmentPlace {
  Point point;
  double heading = 0;
  double curvature = 0;
};

// The place `metres` after the start of an element. Exact within 1e-14 of the length: clothoids by
// Gauss-Legendre quadrature of 24 points, split where the heading turns by more than 2 radians.
AlignmentPlace element_place(const AlignmentElement& element, double metres);

// The curve at a vertex of the straight alignments: clothoid, arc, clothoid.
struct VertexCurve {
  double radius = 0;                         // of the arc, metres; 0: the vertex stays sharp
  double clothoid_in = 0, clothoid_out = 0;  // parameters A, metres; 0: none
};

// A curve that turns by `deflection` radians (positive, below pi). Where both clothoids turn by
// more than the deflection they are shortened so that they meet, and there is no arc.
struct CurveShape {
  double tangent_in = 0, tangent_out = 0;  // from the vertex to the ends of the curve, metres
  double length_in = 0, length_out = 0;    // of the clothoids
  double arc = 0;                          // length of the arc
};
CurveShape curve_shape(double deflection, const VertexCurve& curve);

// The alignment along a line with a curve at each vertex. `curves` has an entry for each point of
// the line; those of the ends mean nothing. Refused: points that repeat another, a turn straight
// back with a curve, and curves that do not fit on the side between two vertices.
std::vector<AlignmentElement> horizontal_alignment(const Line& line,
                                                   const std::vector<VertexCurve>& curves);

// The length of an alignment.
double alignment_length(const std::vector<AlignmentElement>& elements);

// The place at an abscissa, clamped to the alignment; an alignment without elements is refused.
AlignmentPlace alignment_place(const std::vector<AlignmentElement>& elements, double abscissa);

// The abscissas at which chords leave the alignment by at most the tolerance, ends and joints of
// elements included. Each element is divided by itself.
std::vector<double> chord_abscissas(const std::vector<AlignmentElement>& elements,
                                    double tolerance);

// The shares of the energy of the curvature of a line in bands of wavelengths: below 1, 1 to 2,
// 2 to 4, 4 to 8, and more than 8 cycles a kilometre. They sum to 1.
//
// Headings are taken every `step` metres and smoothed over 7, curvature is their difference, and
// windows of `extent` metres (half overlapping, Hann) give a spectrum each. The shares are the
// mean of those of all windows with energy; none where no window has any, as on a straight line.
std::vector<double> curvature_spectrum(const Line& line, double step, double extent);

}  // namespace streetgen
