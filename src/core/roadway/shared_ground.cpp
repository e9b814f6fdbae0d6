#include "roadway/shared_ground.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"
#include "support/infinite.hpp"

namespace streetgen {

namespace {

const double ordinary_angle = 75 * M_PI / 180;  // of a corner that keeps its radius

// Between an arc of so many radians and the tangents at its ends.
double ground_of(double radius, double sweep) {
  return radius * radius * (std::tan(sweep / 2) - sweep / 2);
}

double within(const CornerGround& corner, double share) {
  return std::min(corner.closed, std::max(share, corner.least));
}

}  // namespace

CornerGround corner_ground(const SolvedCorner& corner, double radius_wanted) {
  const CornerArc& arc = corner.gap.corner;
  CornerGround ground{0, ground_of(radius_wanted, M_PI - ordinary_angle)};
  if (arc.radius <= 0) return ground;
  const double half_chord = distance(arc.arc.start, arc.arc.end) / 2;
  ground.closed = ground_of(arc.radius, 2 * std::asin(std::min(1.0, half_chord / arc.radius)));
  return ground;
}

std::vector<double> shared_ground(const std::vector<CornerGround>& corners, double most) {
  constexpr double precision = 1e-6;  // square metres
  const auto together = [&](double share) {
    double sum = 0;
    for (const CornerGround& corner : corners) sum += within(corner, share);
    return sum;
  };
  std::vector<double> shares(corners.size(), infinite);
  if (together(infinite) <= most) return shares;
  double low = 0;
  for (double high = most; high - low > precision;) {
    const double middle = (low + high) / 2;
    (together(middle) <= most ? low : high) = middle;
  }
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (corners[i].closed > within(corners[i], low) + precision)
      shares[i] = within(corners[i], low);
  return shares;
}

}  // namespace streetgen
