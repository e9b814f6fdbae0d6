#include "roadway/arm.hpp"

#include <algorithm>

#include "geometry/polyline.hpp"

namespace streetgen {

double half_at(const Arm& arm, double abscissa) {
  if (arm.half_start == arm.half_end) return arm.half_start;
  const double total = length(arm.line);
  return arm.half_start + (arm.half_end - arm.half_start) * std::clamp(abscissa / total, 0.0, 1.0);
}

Line border_across(const Arm& arm, double abscissa) {
  const Point foot = planar(position_at(arm.line, abscissa).point);
  const Point across = left_normal(local_direction(arm.line, abscissa)) * half_at(arm, abscissa);
  return {foot + across, foot - across};
}

}  // namespace streetgen
