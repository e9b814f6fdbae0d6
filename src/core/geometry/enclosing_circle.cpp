#include "geometry/enclosing_circle.hpp"

#include <cmath>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"

namespace streetgen {

namespace {

bool holds(const Circle& circle, const Point& p) {
  return distance(circle.centre, p) <= circle.radius + same_place;
}

Circle about(const Point& a, const Point& b) { return {(a + b) * 0.5, distance(a, b) / 2}; }

// Of three points on a line, the circle about the two that are farthest apart.
Circle about(const Point& a, const Point& b, const Point& c) {
  const Point u = b - a, v = c - a;
  const double twice = 2 * cross(u, v);
  if (std::abs(twice) <= straight_sine * (dot(u, u) + dot(v, v))) {
    Circle widest = about(a, b);
    for (const Circle& other : {about(a, c), about(b, c)})
      if (other.radius > widest.radius) widest = other;
    return widest;
  }
  const Point out{(v.y * dot(u, u) - u.y * dot(v, v)) / twice,
                  (u.x * dot(v, v) - v.x * dot(u, u)) / twice, 0};
  return {a + out, norm(out)};
}

}  // namespace

Circle enclosing_circle(const Line& points) {
  if (points.empty()) return {};
  Circle circle{points[0], 0};
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (holds(circle, points[i])) continue;
    circle = {points[i], 0};
    for (std::size_t j = 0; j < i; ++j) {
      if (holds(circle, points[j])) continue;
      circle = about(points[i], points[j]);
      for (std::size_t k = 0; k < j; ++k)
        if (!holds(circle, points[k])) circle = about(points[i], points[j], points[k]);
    }
  }
  return circle;
}

}  // namespace streetgen
