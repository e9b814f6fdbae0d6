#include "simulation/smooth_course.hpp"

#include <algorithm>
#include <cmath>

namespace streetgen {

namespace {

// Metres that a course may leave its line.
constexpr double tolerance = 0.05;

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
  double most = 0;
  for (const PlanPiece& piece : course) most = std::max(most, std::abs(piece.curvature));
  if (most == 0) return std::nullopt;
  return 1 / most;
}

}  // namespace streetgen
