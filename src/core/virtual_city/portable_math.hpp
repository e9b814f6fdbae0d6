// The four operations and the square root alone, which IEEE 754 defines to the bit: unlike the
// functions of <cmath>, these give the same values on every machine.
#pragma once

#include <cmath>

#include "geometry/polyline.hpp"

namespace streetgen::portable {

inline double norm(const Point& a) { return std::sqrt(dot(a, a)); }
inline double distance(const Point& a, const Point& b) { return portable::norm(a - b); }
inline Point unit(const Point& a) { return a * (1 / portable::norm(a)); }

inline double distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const Point ab = b - a;
  const double along = dot(p - a, ab) / dot(ab, ab);
  return portable::distance(p, a + ab * std::fmin(std::fmax(along, 0), 1));
}

// exp(-u) for u >= 0, to a few units in the last place.
inline double decay(double u) {
  if (u > 700) return 0;
  int halvings = 0;
  for (; u > 0.5; u /= 2) ++halvings;
  double term = 1, sum = 1;
  for (int i = 1; i < 18; ++i) sum += term *= -u / i;
  for (; halvings > 0; --halvings) sum *= sum;
  return sum;
}

// A unit vector turned counter-clockwise, up to half a turn.
inline Point turned(const Point& direction, double degrees) {
  const double angle = degrees * (3.14159265358979323846 / 180);
  double power = 1, cosine = 0, sine = 0;
  for (int i = 0; i < 30; i += 2) {
    cosine += power;
    power *= angle / (i + 1);
    sine += power;
    power *= -angle / (i + 2);
  }
  return portable::unit(
      {direction.x * cosine - direction.y * sine, direction.x * sine + direction.y * cosine, 0});
}

inline Point to_millimetre(const Point& p) {
  return {std::round(p.x * 1000) / 1000, std::round(p.y * 1000) / 1000, 0};
}

}  // namespace streetgen::portable
