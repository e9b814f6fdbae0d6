#include "interconnection/path_choice.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace streetgen {

namespace {

// A driver slows down to this share of the speed, and bears this acceleration to the side.
constexpr double slowed_down = 0.15;
constexpr double lateral_acceleration = 3;  // m/s2
constexpr double sharpest_drivable = 30;    // degrees between chords of a path
constexpr double angle_step = 1e-6;         // degrees, to which angles are rounded

}  // namespace

double speed_radius(double speed) {
  const double v = slowed_down * speed / 3.6;
  return std::max(car_radius, v * v / lateral_acceleration);
}

bool drivable(const Line& path) { return sharpest_turn(path) <= sharpest_drivable; }

double rounded_degrees(double angle) {
  const double steps = std::round(angle / angle_step);
  return steps * angle_step <= -180 + angle_step / 2 ? 180 : steps * angle_step + 0.0;
}

bool PathChoice::offer(std::optional<Trajectory> path) {
  if (!path) return false;
  const bool clear = !kerbs_.stop(path->line, from_, to_);
  const bool made = clear && (papers_ || drivable(path->line));
  if (made || !offered_ || (clear && !best_is_clear_)) {
    best_ = std::move(*path);
    best_is_clear_ = clear;
    offered_ = true;
  }
  return made;
}

}  // namespace streetgen
