#include "lane/bound_side.hpp"

#include <cstddef>

#include "geometry/polyline.hpp"
#include "support/infinite.hpp"

namespace streetgen {

namespace {

bool left_of(const Point& from, const Point& to, const Point& place) {
  return cross(to - from, place - from) > 0;
}

}  // namespace

bool lies_left(const Line& line, const Point& place) {
  std::size_t nearest = 1;
  double least = infinite;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double apart = distance_to_segment(place, line[i - 1], line[i]);
    if (apart < least) least = apart, nearest = i;
  }
  const Point &from = line[nearest - 1], &to = line[nearest];
  const bool left = left_of(from, to, place);
  if (nearest + 1 == line.size() || !same(nearest_on_segment(place, from, to), to)) return left;
  // At a vertex, the side counts on which the line leaves the place.
  const Point& next = line[nearest + 1];
  return left != left_of(to, next, place) && left == left_of(from, to, next) ? !left : left;
}

Point middle_point(const Line& line) {
  return line.size() > 2 ? line[line.size() / 2] : (line.front() + line.back()) * 0.5;
}

bool are_bounds(const Line& left, const Line& right) {
  const auto beside = [](const Line& line, const Line& other, bool on_left) {
    return lies_left(line, middle_point(other)) == on_left &&
           lies_left(line, middle_point(reversed(other))) == on_left;
  };
  return beside(left, right, false) && beside(right, left, true);
}

}  // namespace streetgen
