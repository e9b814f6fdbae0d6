#include "interconnection/turn.hpp"

#include <cmath>

#include "geometry/polyline.hpp"
#include "streetgen/trajectory.hpp"

namespace streetgen {

double turn_angle(const Point& from, const Point& to) {
  const double angle = std::atan2(cross(from, to), dot(from, to)) * 180 / M_PI;
  return angle == -180 ? 180 : angle;
}

Turn turn_of(double angle) {
  const double cosine = std::cos(angle * M_PI / 180);
  if (cosine >= parallel_cosine) return Turn::through;
  if (cosine <= -parallel_cosine) return Turn::u_turn;
  return angle > 0 ? Turn::left : Turn::right;
}

Turn turn_called(bool turns_back, double angle, double side) {
  if (turns_back) return Turn::u_turn;
  const Turn turn = turn_of(angle);
  if (turn != Turn::u_turn) return turn;
  return side > 0 ? Turn::left : Turn::right;
}

}  // namespace streetgen
