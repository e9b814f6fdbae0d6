// Places on lines, arcs and clothoids, and the curve of clothoid, arc, clothoid at a vertex.
#include <algorithm>
#include <cmath>

#include "road/quadrature.hpp"
#include "streetgen/alignment.hpp"

namespace streetgen {
namespace {

// sin(x) / x, also at 0.
double sinc(double x) { return std::abs(x) < 1e-8 ? 1 : std::sin(x) / x; }

// The chord of a curve whose heading is a quadratic of the length.
Point clothoid_chord(double heading, double curvature, double rate, double metres) {
  const double turn = std::abs(curvature * metres) + std::abs(rate * metres * metres) / 2;
  const int parts = std::max(1, static_cast<int>(std::ceil(turn / 2)));
  const double part = metres / parts;
  Point chord;
  for (int i = 0; i < parts; ++i) {
    double x = 0, y = 0;
    for (const QuadraturePoint& q : quadrature()) {
      const double s = (i + q.at) * part;
      const double angle = heading + (curvature + rate * s / 2) * s;
      x += q.weight * std::cos(angle);
      y += q.weight * std::sin(angle);
    }
    chord.x += part * x;
    chord.y += part * y;
  }
  return chord;
}

// The end of a clothoid from a straight line, in its own axes: xM = x - R sin tau, and the shift
// d = y - R (1 - cos tau) of the arc's circle from the straight line.
struct ClothoidEnd {
  double middle = 0, shift = 0;
};

ClothoidEnd clothoid_end(double radius, double length) {
  if (length <= 0) return {};
  const double tau = length / (2 * radius);
  const Point end = clothoid_chord(0, 0, 1 / (radius * length), length);
  return {end.x - radius * std::sin(tau), end.y - radius * (1 - std::cos(tau))};
}

}  // namespace

AlignmentPlace element_place(const AlignmentElement& element, double metres) {
  const double rate =
      element.length > 0 ? (element.curvature_end - element.curvature_start) / element.length : 0;
  AlignmentPlace place;
  place.curvature = element.curvature_start + rate * metres;
  place.heading = element.heading + (element.curvature_start + rate * metres / 2) * metres;
  Point chord;
  if (rate != 0) {
    chord = clothoid_chord(element.heading, element.curvature_start, rate, metres);
  } else {
    const double half = element.curvature_start * metres / 2;
    const double length = metres * sinc(half);
    chord = {length * std::cos(element.heading + half), length * std::sin(element.heading + half),
             0};
  }
  place.point = {element.start.x + chord.x, element.start.y + chord.y, element.start.z};
  return place;
}

CurveShape curve_shape(double deflection, const VertexCurve& curve) {
  const double radius = curve.radius;
  if (radius <= 0 || deflection <= 0) return {};
  double tau_in = curve.clothoid_in * curve.clothoid_in / (2 * radius * radius);
  double tau_out = curve.clothoid_out * curve.clothoid_out / (2 * radius * radius);
  const double turned = tau_in + tau_out;
  if (turned > deflection) {
    tau_in *= deflection / turned;
    tau_out *= deflection / turned;
  }
  CurveShape shape;
  shape.length_in = 2 * radius * tau_in;
  shape.length_out = 2 * radius * tau_out;
  shape.arc = turned > deflection ? 0 : radius * (deflection - turned);
  const ClothoidEnd in = clothoid_end(radius, shape.length_in);
  const ClothoidEnd out = clothoid_end(radius, shape.length_out);
  const double half = std::tan(deflection / 2);
  const double skew = (out.shift - in.shift) / std::sin(deflection);
  shape.tangent_in = (radius + in.shift) * half + in.middle + skew;
  shape.tangent_out = (radius + out.shift) * half + out.middle - skew;
  return shape;
}

}  // namespace streetgen
