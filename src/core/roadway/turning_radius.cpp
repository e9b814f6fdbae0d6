#include <algorithm>
#include <cmath>
#include <string>

#include "streetgen/corner.hpp"
#include "streetgen/error.hpp"

namespace streetgen {

double turning_radius(double speed, double width, const char* mode, double minimal,
                      double maximal) {
  const bool paper = std::string(mode) == "paper";
  if (!paper && std::string(mode) != "setra")
    throw Error(ErrorKind::invalid_input,
                "unknown mode \"" + std::string(mode) + "\", expected \"paper\" or \"setra\"");
  // V85 = V0 / (1 + 346 / R^1.5), V0 = 10 w + 65 with w the half width; singular at V0.
  const double limit_speed = 10 * (width / 2) + 65;
  const double clamped = std::min(speed, 0.99 * limit_speed);
  const double ratio = clamped / (limit_speed - clamped);
  const double radius =
      paper ? std::sqrt(346.0) * std::sqrt(ratio) : std::pow(346 * ratio, 2.0 / 3.0);
  return std::clamp(radius, minimal, maximal);
}

}  // namespace streetgen
