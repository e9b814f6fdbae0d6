// Planar measures of one polyline.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

inline Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Point operator*(const Point& a, double k) { return {a.x * k, a.y * k, a.z * k}; }
inline double dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }
inline double cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }
inline double norm(const Point& a) { return std::sqrt(dot(a, a)); }
inline double distance(const Point& a, const Point& b) { return norm(a - b); }
// Without z.
inline Point planar(const Point& a) { return {a.x, a.y, 0}; }
// Zero stays zero.
inline Point unit(const Point& a) {
  const double n = norm(a);
  return n > 0 ? Point{a.x / n, a.y / n, 0} : Point{};
}
// A quarter turn counter-clockwise.
inline Point left_normal(const Point& a) { return {-a.y, a.x, 0}; }

// Point by point, of lines, rings and surfaces.
inline bool same(const Point& a, const Point& b) { return a.x == b.x && a.y == b.y; }
template <class Part>
bool same(const std::vector<Part>& a, const std::vector<Part>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Part& p, const Part& q) { return same(p, q); });
}

double length(const Line& line);
Line reversed(Line line);
Line planar(Line line);
// Without repeated consecutive points.
Line distinct(Line line);
// Without pieces that have no direction, from the first place to the last; a line that has no
// others as it is.
Line without_noise(const Line& line);

// The segment that holds `abscissa` (clamped), and where in it.
struct LinePosition {
  std::size_t segment = 0;
  Point point;
  Point direction;  // unit, of the segment
};
LinePosition position_at(const Line& line, double abscissa);
// Unit direction of the substring at +-0.1 m around `abscissa`.
Point local_direction(const Line& line, double abscissa);
// From abscissa u to abscissa v; backwards when u > v.
Line substring(const Line& line, double u, double v);

// Of the segments a to b and c to d, ends included; none where they are parallel.
std::optional<Point> crossing(const Point& a, const Point& b, const Point& c, const Point& d);

Point nearest_on_segment(const Point& p, const Point& a, const Point& b);
double distance_to_segment(const Point& p, const Point& a, const Point& b);
double distance_to_line(const Point& p, const Line& line);
// Of the place on the line that is nearest to p, the first of equal ones.
double nearest_abscissa(const Point& p, const Line& line);
// Whether the line is anywhere nearer to p than `reach`.
bool comes_within(const Point& p, const Line& line, double reach);

// Chords of a quarter circle where two offsets join: behind a node, about an outer bend.
constexpr int join_quarter = 8;

// Points on the circle about `centre` from `from` to `to` (both left out), turning
// counter-clockwise or clockwise; a quarter circle has `quarter` chords.
void append_arc(Ring& ring, const Point& centre, const Point& from, const Point& to,
                bool counter_clockwise, int quarter);

double signed_area(const Ring& ring);
double area(const MultiPolygon& surface);

}  // namespace streetgen
