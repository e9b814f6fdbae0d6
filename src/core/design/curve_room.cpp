#include "design/curve_room.hpp"
#include "support/infinite.hpp"

#include <algorithm>
#include <cmath>

namespace streetgen {
namespace {

constexpr int steps = 1024;
constexpr double sharpest = 170 * M_PI / 180;

}  // namespace

CurveRoom::CurveRoom(const DesignRules& rules) {
  const VertexCurve curve{rules.radius, rules.clothoid, rules.clothoid};
  for (int i = 0; i <= steps; ++i)
    tangents_.push_back(curve_shape(sharpest * i / steps, curve).tangent_in);
}

double CurveRoom::tangent(double turn) const {
  turn = std::abs(turn);
  if (!(turn <= sharpest)) return infinite;
  if (turn < 1e-9) return 0;
  return tangents_[std::min(steps, static_cast<int>(turn / sharpest * steps) + 1)];
}

}  // namespace streetgen
