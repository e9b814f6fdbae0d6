#include "layout/arm.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"

namespace streetgen {

double Arm::reach() const {
  return std::max({half_start, half_end, widest}) + std::abs(roadway_offset);
}

double Arm::end_to(int side) const {
  const double added = merging.empty() ? 0 : merging_at(length(line), side);
  return half_end + side * roadway_offset + added;
}

double half_at(const Arm& arm, double abscissa, int side) {
  const double start = arm.half_start + side * arm.roadway_offset;
  const double added = arm.merging_at(abscissa, side);
  if (arm.half_start == arm.half_end) return start + added;
  const double share = std::clamp(abscissa / length(arm.line), 0.0, 1.0);
  return start + (arm.half_end + side * arm.roadway_offset - start) * share + added;
}

std::pair<double, double> halves(const Arm& arm, double u, double v, int side) {
  if (arm.merging.empty()) return {arm.start_to(side), arm.end_to(side)};
  const double from = half_at(arm, u, side);
  if (u == v) return {from, from};
  return WidthProfile::extended(u, from, v, half_at(arm, v, side), length(arm.line));
}

double half_towards(const Arm& arm, const Point& place) {
  const LinePosition foot = position_at(arm.line, nearest_abscissa(place, arm.line));
  return arm.start_to(cross(foot.direction, place - foot.point) > 0 ? +1 : -1);
}

bool as_wide(const Arm& a, const Arm& b) {
  return std::abs(a.start_to(+1) - b.start_to(-1)) <= same_width &&
         std::abs(a.start_to(-1) - b.start_to(+1)) <= same_width;
}

bool nearly_in_line(double angle) { return std::abs(angle - M_PI) < 20 * M_PI / 180 + same_angle; }

Line line_with_places(const Arm& arm, const WidthProfile& profile, double start, double end) {
  if (profile.empty() || start >= end) return distinct(planar(substring(arm.line, start, end)));
  Line part;
  profile.each_stretch(start, end, [&](const auto& from, const auto& to) {
    const Line piece = substring(arm.line, from.abscissa, to.abscissa);
    part.insert(part.end(), piece.begin(), piece.end());
  });
  return distinct(planar(std::move(part)));
}

Line border_across(const Arm& arm, double abscissa) {
  const Point foot = planar(position_at(arm.line, abscissa).point);
  const Point across = left_normal(local_direction(arm.line, abscissa));
  return {foot + across * half_at(arm, abscissa, +1), foot - across * half_at(arm, abscissa, -1)};
}

}  // namespace streetgen
