#include "simulation/smooth_course.hpp"

#include <algorithm>
#include <cmath>

#include "road/heading.hpp"

namespace streetgen {

namespace {

// Metres that a course may leave its line.
constexpr double tolerance = 0.05;
// Metres.  A car does not feel how a shorter stretch bends.
constexpr double felt = 1;
// One by metres: what rounding leaves.
constexpr double straight = 1e-6;

// A course goes on straight at both ends.
Point beyond(const std::vector<PlanPiece>& course, double metres) {
  const double end = length(course), on = std::clamp(metres, 0.0, end);
  const ChainPlace place = place_at(course, on);
  return place.point + along(place.heading) * (metres - on);
}

}  // namespace

std::vector<PlanPiece> lane_course(const Line& lane, const ChainEnds& ends) {
  return plan_view(lane, tolerance, ends);
}

std::vector<PlanPiece> movement_course(const Line& path, const std::vector<PlanPiece>& lane_in,
                                       const std::vector<PlanPiece>& lane_out, double width) {
  return path_view(path, place_at(lane_in, length(lane_in)), lane_out.front().start, tolerance,
                   width);
}

std::optional<double> tightest_radius(const std::vector<PlanPiece>& course) {
  if (course.empty()) return std::nullopt;
  const double end = length(course);
  double most = 0;
  for (double metres = 0; metres < end + felt / 4; metres += felt / 4) {
    const Point before = beyond(course, metres - felt), here = beyond(course, metres),
                after = beyond(course, metres + felt);
    most = std::max(most, std::abs(turn_from(here - before, after - here)) / felt);
  }
  if (most <= straight) return std::nullopt;
  return 1 / most;
}

}  // namespace streetgen
