#include "layout/drawn_arc.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"

namespace streetgen {

namespace {

constexpr int corner_quarter = 16;
constexpr double coarsest = 60;  // metres: a greater radius has more chords
constexpr int most_finer = 16;

}  // namespace

Line drawn_arc(const CornerArc& corner) {
  Line line{corner.arc.start};
  if (corner.radius > 0) {
    // Clockwise about its centre, but for the slight outside of a nearly straight pair.
    const Point from = corner.arc.start - corner.centre, to = corner.arc.end - corner.centre;
    const bool outside = cross(from, to) > 0 && dot(from, to) > 0;
    const int finer = std::max(1, static_cast<int>(std::ceil(std::sqrt(corner.radius / coarsest))));
    append_arc(line, corner.centre, corner.arc.start, corner.arc.end, outside,
               corner_quarter * std::min(finer, most_finer));
  }
  line.push_back(corner.arc.end);
  return line;
}

}  // namespace streetgen
