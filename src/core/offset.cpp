#include "offset.hpp"

#include <algorithm>
#include <cmath>

#include "polyline.hpp"

namespace streetgen {

namespace {
constexpr int join_quarter = 8;
constexpr double straight = 1e-12;  // sine of a bend that needs no join
}  // namespace

std::vector<OffsetPiece> offset_pieces(const Line& axis, double offset, int side) {
  std::vector<OffsetPiece> pieces;
  pieces.reserve(2 * axis.size());
  double abscissa = 0;
  Point last{};
  for (std::size_t i = 1; i < axis.size(); ++i) {
    const double d = distance(axis[i - 1], axis[i]);
    if (d == 0) continue;
    const Point direction = unit(axis[i] - axis[i - 1]);
    const Point shift = left_normal(direction) * (side * offset);
    const Point start = planar(axis[i - 1]) + shift;
    if (!pieces.empty() && cross(last, direction) * side < -straight)
      pieces.push_back({pieces.back().end, start, planar(axis[i - 1]), true, abscissa, abscissa});
    pieces.push_back({start, planar(axis[i]) + shift, {}, false, abscissa, abscissa + d});
    abscissa += d;
    last = direction;
  }
  return pieces;
}

Line kerb_line(const Line& axis, double u, double v, double half_start, double half_end, int side) {
  const Line part = distinct(planar(substring(axis, std::min(u, v), std::max(u, v))));
  const double total = length(axis);
  const auto half_at = [&](double abscissa) {
    return half_start + (half_end - half_start) * (total > 0 ? abscissa / total : 0);
  };
  double abscissa = std::min(u, v);
  const double first_half = half_at(abscissa);
  Line kerb;
  if (part.size() < 2) {
    const Point across = left_normal(place_at(axis, abscissa).direction) * side;
    kerb.push_back(planar(part[0]) + across * first_half);
    return kerb;
  }
  Point direction = unit(part[1] - part[0]);
  kerb.push_back(part[0] + left_normal(direction) * (side * first_half));
  for (std::size_t i = 1; i + 1 < part.size(); ++i) {
    abscissa += distance(part[i - 1], part[i]);
    const Point next = unit(part[i + 1] - part[i]);
    const double half = half_at(abscissa);
    const double turn = cross(direction, next) * side;
    const Point before = part[i] + left_normal(direction) * (side * half);
    const Point after = part[i] + left_normal(next) * (side * half);
    if (turn < -straight) {
      kerb.push_back(before);
      append_arc(kerb, part[i], before, after, side < 0, join_quarter);
      kerb.push_back(after);
    } else {
      const double cosine = std::max(dot(direction, next), -0.999);
      kerb.push_back(part[i] +
                     (left_normal(direction) + left_normal(next)) * (side * half / (1 + cosine)));
    }
    direction = next;
  }
  kerb.push_back(part.back() + left_normal(direction) * (side * half_at(std::max(u, v))));
  return u > v ? reversed(kerb) : kerb;
}

}  // namespace streetgen
