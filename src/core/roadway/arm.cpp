#include "roadway/arm.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"

namespace streetgen {

double Arm::reach() const {
  return std::max({half_start, half_end, widest}) + std::abs(roadway_offset);
}

double half_at(const Arm& arm, double abscissa, int side) {
  const double start = arm.start_to(side);
  if (arm.half_start == arm.half_end) return start;
  const double total = length(arm.line);
  return start + (arm.end_to(side) - start) * std::clamp(abscissa / total, 0.0, 1.0);
}

double half_towards(const Arm& arm, const Point& place) {
  const LinePosition foot = position_at(arm.line, nearest_abscissa(place, arm.line));
  return arm.start_to(cross(foot.direction, place - foot.point) > 0 ? +1 : -1);
}

bool as_wide(const Arm& a, const Arm& b) {
  return std::abs(a.start_to(+1) - b.start_to(-1)) <= same_width &&
         std::abs(a.start_to(-1) - b.start_to(+1)) <= same_width;
}

Line border_across(const Arm& arm, double abscissa) {
  const Point foot = planar(position_at(arm.line, abscissa).point);
  const Point across = left_normal(local_direction(arm.line, abscissa));
  return {foot + across * half_at(arm, abscissa, +1), foot - across * half_at(arm, abscissa, -1)};
}

}  // namespace streetgen
