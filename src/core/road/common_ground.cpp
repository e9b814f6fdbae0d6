#include "streetgen/common_ground.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

constexpr double spacing = 1;            // metres
constexpr int most_places = 1000;        // of one line
constexpr double one_direction = 0.866;  // cosine of 30 degrees
constexpr double direction_room = 2;  // metres to both sides, over which a line has its direction

Point direction_at(const Line& line, double abscissa) {
  return unit(position_at(line, abscissa + direction_room).point -
              position_at(line, abscissa - direction_room).point);
}

// How far `other` is where it goes side by side with what passes p in direction d; at most `most`.
double gap_beside(const Point& p, const Point& d, const Line& other, double most) {
  double gap = most;
  for (std::size_t i = 0; i + 1 < other.size(); ++i) {
    if (std::abs(dot(unit(other[i + 1] - other[i]), d)) < one_direction) continue;
    const Point place = nearest_on_segment(p, other[i], other[i + 1]), to = place - p;
    // Beyond its ends the other line is beside nothing.
    const bool end = same(place, other.front()) || same(place, other.back());
    if (std::abs(dot(to, d)) <= (end ? spacing : std::max(spacing, norm(to))) / 2)
      gap = std::min(gap, norm(to));
  }
  return gap;
}

}  // namespace

double common_ground(const Line& given, const Line& given_other, double distance) {
  const Line line = distinct(planar(given)), other = distinct(planar(given_other));
  const double all = length(line), most = 2 * distance;
  if (!(all > 0)) return 0;
  const int places = std::clamp(static_cast<int>(std::ceil(all / spacing)), 8, most_places);
  double shared = 0;
  for (int i = 0; i < places; ++i) {
    poll_cancel();
    const double at = all * (i + 0.5) / places;
    const Point p = position_at(line, at).point;
    shared += 1 - gap_beside(p, direction_at(line, at), other, most) / most;
  }
  return shared / places;
}

}  // namespace streetgen
