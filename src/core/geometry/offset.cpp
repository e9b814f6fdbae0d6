#include "geometry/offset.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"

namespace streetgen {

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
    if (!pieces.empty() && cross(last, direction) * side < -straight_sine)
      pieces.push_back(
          {pieces.back().end, start, planar(axis[i - 1]), true, abscissa, abscissa, i - 1});
    pieces.push_back({start, planar(axis[i]) + shift, {}, false, abscissa, abscissa + d, i - 1});
    abscissa += d;
    last = direction;
  }
  return pieces;
}

KerbLine kerb_line(const Line& axis, double u, double v, double half_start, double half_end,
                   int side) {
  const Line part = distinct(planar(substring(axis, std::min(u, v), std::max(u, v))));
  const double total = half_start == half_end ? 0 : length(axis);
  const auto half_at = [&](double abscissa) {
    return half_start + (half_end - half_start) * (total > 0 ? abscissa / total : 0);
  };
  double abscissa = std::min(u, v);
  KerbLine kerb;
  kerb.line.reserve(part.size());
  if (part.size() < 2) {
    const Point across = left_normal(position_at(axis, abscissa).direction) * side;
    kerb.line.push_back(planar(part[0]) + across * half_at(abscissa));
    return kerb;
  }
  Point direction = unit(part[1] - part[0]);
  kerb.line.push_back(part[0] + left_normal(direction) * (side * half_at(abscissa)));
  double trimmed = 0;  // of the segment before, by the bend before it
  for (std::size_t i = 1; i + 1 < part.size(); ++i) {
    const double size = distance(part[i - 1], part[i]);
    abscissa += size;
    const Point next = unit(part[i + 1] - part[i]);
    const double half = half_at(abscissa);
    const int beside = half < 0 ? -side : side;
    const double turn = cross(direction, next) * beside;
    const Point before = left_normal(direction) * (side * half);
    const Point after = left_normal(next) * (side * half);
    double trim = 0;
    if (std::abs(half) < rounding) {
      kerb.line.push_back(part[i]);
    } else if (turn < 0 && distance(before, after) > same_place) {
      kerb.line.push_back(part[i] + before);
      append_arc(kerb.line, part[i], part[i] + before, part[i] + after, beside < 0, join_quarter);
      kerb.line.push_back(part[i] + after);
    } else {
      const double cosine = std::max(dot(direction, next), -0.999);
      trim = std::abs(half) * std::sqrt((1 - cosine) / (1 + cosine));
      kerb.line.push_back(part[i] + (before + after) * (1 / (1 + cosine)));
    }
    if (trimmed + trim > size + 1e-9) kerb.whole = false;
    trimmed = trim;
    direction = next;
  }
  if (trimmed > distance(part[part.size() - 2], part.back()) + 1e-9) kerb.whole = false;
  kerb.line.push_back(part.back() + left_normal(direction) * (side * half_at(std::max(u, v))));
  if (u > v) kerb.line = reversed(std::move(kerb.line));
  return kerb;
}

}  // namespace streetgen
