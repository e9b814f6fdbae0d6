#include "streetgen/road_standard.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "streetgen/error.hpp"

namespace streetgen {
namespace {

// Least radii of the Portuguese norm (JAE P3/94) at a superelevation of 7 %.
struct NormRadius {
  double speed, radius;
};
constexpr NormRadius norm_radii[] = {{40, 55},   {50, 85},   {60, 130},  {70, 180},
                                     {80, 240},  {90, 320},  {100, 420}, {110, 560},
                                     {120, 700}, {130, 900}, {140, 1200}};

double friction_of(const NormRadius& n) { return n.speed * n.speed / (127 * n.radius) - 0.07; }

// Friction that the norm relies on, linear between its speeds and constant beyond.
double norm_friction(double speed) {
  if (speed <= norm_radii[0].speed) return friction_of(norm_radii[0]);
  for (std::size_t i = 1; i < std::size(norm_radii); ++i)
    if (speed <= norm_radii[i].speed) {
      const double share =
          (speed - norm_radii[i - 1].speed) / (norm_radii[i].speed - norm_radii[i - 1].speed);
      return (1 - share) * friction_of(norm_radii[i - 1]) + share * friction_of(norm_radii[i]);
    }
  return friction_of(norm_radii[std::size(norm_radii) - 1]);
}

}  // namespace

double least_radius(double speed, double superelevation, double friction) {
  const double grip = superelevation + (friction < 0 ? norm_friction(speed) : friction);
  if (!(grip > 0))
    throw Error(ErrorKind::invalid_input,
                "superelevation and friction together are " + text_of(grip),
                "A car needs a sum above 0 to turn.");
  return speed * speed / (127 * grip);
}

}  // namespace streetgen
