// The path that a vehicle takes, of several between two lanes.
#pragma once

#include <optional>

#include "interconnection/kerb_obstacle.hpp"
#include "streetgen/trajectory.hpp"

namespace streetgen {

constexpr double car_radius = 3;  // metres, least of a car's path

// The least radius, metres, that a driver takes at a speed (km/h), slowed down for the turn.
double speed_radius(double speed);

// Whether the path has no corner that a car cannot drive.
bool drivable(const Line& path);

// Degrees in (-180, 180], rounded so that an angle does not depend on how it was computed.
double rounded_degrees(double angle);

// The choice of paths that are offered one by one, from the best on: the first that is clear of the
// kerbs and drivable, else the first that is clear, else the first.  The rule of the paper asks for
// clear alone.
class PathChoice {
 public:
  // from, to: the places of the two lanes' border lines in the list that the kerbs were made of.
  PathChoice(const Kerbs& kerbs, int from, int to, bool papers)
      : kerbs_(kerbs), from_(from), to_(to), papers_(papers) {}

  // Whether the choice is made.
  bool offer(std::optional<Trajectory> path);

  bool clear() const { return best_is_clear_; }
  Trajectory best() { return std::move(best_); }

 private:
  const Kerbs& kerbs_;
  int from_, to_;
  bool papers_;
  Trajectory best_;
  bool offered_ = false, best_is_clear_ = false;
};

}  // namespace streetgen
