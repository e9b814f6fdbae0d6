#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"
#include "streetgen/object.hpp"

namespace streetgen {

namespace {

constexpr double at_vertex = 1e-9;  // metres

double clockwise_from_north(const Point& direction) {
  const double angle = std::atan2(direction.x, direction.y);
  return angle < 0 ? angle + 2 * M_PI : angle;
}

// Of the vertex between two segments; where the line turns back on itself, that of the first one.
Point halfway(const Point& before, const Point& after) {
  const Point sum = unit(before + after);
  return norm(sum) > 0 ? sum : before;
}

}  // namespace

StandingPlace place_beside(const Line& axis, const PlaceBeside& beside) {
  const Line line = distinct(planar(axis));
  const std::size_t last = line.size() - 1;
  const double abscissa = std::max(0.0, beside.abscissa);
  double start = 0;
  std::size_t i = 0;
  double size = distance(line[0], line[1]);
  while (i + 1 < last && abscissa > start + size - at_vertex) {
    start += size;
    ++i;
    size = distance(line[i], line[i + 1]);
  }
  Point direction = unit(line[i + 1] - line[i]);
  const double along = std::min(abscissa - start, size);
  const Point foot = line[i] + direction * along;
  if (i > 0 && along <= at_vertex) direction = halfway(unit(line[i] - line[i - 1]), direction);
  return {foot + left_normal(direction) * beside.offset, clockwise_from_north(direction)};
}

PlaceBeside beside_axis(const Line& axis, const Point& point) {
  const Line line = distinct(planar(axis));
  const Point place = planar(point);
  PlaceBeside found;
  double nearest = INFINITY, start = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Point way = line[i + 1] - line[i];
    const double size = norm(way);
    const Point direction = way * (1 / size);
    const double along = std::clamp(dot(place - line[i], direction), 0.0, size);
    const double away = distance(place, line[i] + direction * along);
    if (away < nearest) {
      nearest = away;
      Point side = direction;
      if (along == size && i + 2 < line.size())
        side = halfway(direction, unit(line[i + 2] - line[i + 1]));
      found = {start + along, cross(side, place - line[i] - direction * along) < 0 ? -away : away};
    }
    start += size;
  }
  return found;
}

}  // namespace streetgen
