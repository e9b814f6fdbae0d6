// A path that is led to ends beside its own.
#include <cmath>
#include <cstddef>
#include <vector>

#include "geometry/polyline.hpp"
#include "road/heading.hpp"
#include "streetgen/plan_view.hpp"

namespace streetgen {

namespace {

constexpr double at_its_end = 1e-6;  // metres

// The direction at a point of a line, given those at its ends.
Point way_along(const Line& line, std::size_t i, const Point& first, const Point& last) {
  if (i == 0) return first;
  return i + 1 == line.size() ? last : unit(line[i + 1] - line[i - 1]);
}

// Metres by which a place lies to the left of a point from which one goes in a direction.
double metres_left(const Point& from, const Point& way, const Point& place) {
  return cross(way, place - from);
}

}  // namespace

Line path_beside(const Line& path, const ChainPlace& from, const ChainPlace& to) {
  Line line = distinct(path);
  for (Point& p : line) p = planar(p);
  if (line.size() < 2) return path;
  const Point way_from = along(from.heading), way_to = along(to.heading);
  const double first = metres_left(line.front(), way_from, planar(from.point));
  const double last = metres_left(line.back(), way_to, planar(to.point));
  if (std::abs(first) < at_its_end && std::abs(last) < at_its_end) return path;
  const double total = length(line);
  Line beside;
  double at = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i > 0) at += distance(line[i - 1], line[i]);
    const Point left = left_normal(way_along(line, i, way_from, way_to));
    beside.push_back(line[i] + left * (first + (last - first) * at / total));
  }
  return beside;
}

}  // namespace streetgen
