#include "interconnection/movement_angle.hpp"

#include <cmath>

#include "geometry/polyline.hpp"
#include "interconnection/turn.hpp"

namespace streetgen {

long long in_steps(double degrees) { return std::llround(1e4 * degrees + 0.1137); }

double movement_angle(const Leg& from, const Leg& to) {
  const LaneEnd &in = from.in.front(), &out = to.out.front();
  const double angle = turn_angle(in.direction, out.direction);
  if (turn_of(angle) != Turn::u_turn) return angle;
  const bool to_the_left = cross(in.direction, out.place - in.place) >= 0;
  return to_the_left ? std::abs(angle) : -std::abs(angle);
}

double outset_angle(const Leg& from, const Leg& to) {
  return turn_angle(from.outset * -1, to.outset);
}

double movement_order(const Leg& from, const Leg& to) {
  const LaneEnd &in = from.in.front(), &out = to.out.front();
  const Point way = out.place - in.place;
  return movement_angle(from, to) + (norm(way) > 0 ? turn_angle(in.direction, way) : 0);
}

}  // namespace streetgen
