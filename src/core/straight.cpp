#include "straight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "polyline.hpp"
#include "ring.hpp"

namespace streetgen {

namespace {

constexpr double together = 1e-4;  // metres

// Where the first lies on the second, metres along the first.
Range common(const Straight& first, const Straight& second) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Range all{infinite, -infinite};
  const auto add = [&](const Range& range) {
    if (range.empty()) return;
    all = {std::min(all.from, range.from), std::max(all.to, range.to)};
  };
  for (const Point& end : {second.start, second.end}) {
    const Point away = end - first.origin;
    const double at = dot(away, first.along), off = cross(first.along, away);
    const double half = std::sqrt(std::max(0.0, together * together - off * off));
    add({at - half, at + half});
  }
  const Point away = first.origin - second.origin;
  Range beside{first.from, first.to};
  beside.hold(dot(away, second.along), dot(first.along, second.along), second.from, second.to);
  beside.hold(cross(second.along, away), cross(second.along, first.along), -together, together);
  add(beside);
  return {std::max(all.from, first.from), std::min(all.to, first.to)};
}

// Ascending, and may overlap.
void append_without(const std::vector<Range>& taken, const Straight& piece,
                    std::vector<Straight>& rest) {
  Straight left = piece;
  const auto keep_up_to = [&](double to) {
    if (to - left.from < together) return;
    rest.push_back(left);
    rest.back().to = to;
    if (to < piece.to) rest.back().end = piece.origin + piece.along * to;
  };
  for (const Range& range : taken) {
    keep_up_to(range.from);
    if (range.to <= left.from) continue;
    left.from = range.to;
    left.start = piece.origin + piece.along * range.to;
  }
  keep_up_to(piece.to);
}

}  // namespace

double Straight::square_from(const Point& p) const {
  const Point away = p - origin;
  const Point off = away - along * std::clamp(dot(away, along), from, to);
  return dot(off, off);
}

void Range::hold(double start, double slope, double least, double most) {
  if (slope == 0) {
    if (start < least || start > most) to = from;
    return;
  }
  const double low = (least - start) / slope, high = (most - start) / slope;
  from = std::max(from, std::min(low, high));
  to = std::min(to, std::max(low, high));
}

void append_pieces(const Line& line, double from, double to, const Point& origin,
                   std::vector<Straight>& pieces) {
  double walked = 0;
  for (std::size_t i = 1; i < line.size() && walked < to; ++i) {
    const Point start = planar(line[i - 1] - origin), end = planar(line[i] - origin);
    const double size = distance(start, end);
    const bool whole = from - walked <= same_place, on = to - walked >= size - same_place;
    const double first = whole ? 0 : from - walked, last = on ? size : to - walked;
    walked += size;
    if (last - first <= same_place) continue;
    const Point along = unit(end - start);
    pieces.push_back({start, along, first, last, whole ? start : start + along * first,
                      on ? end : start + along * last});
  }
}

std::vector<Straight> apart(const std::vector<Straight>& pieces,
                            const std::vector<Straight>& others, const BoxRuns& boxes_of_others) {
  std::vector<Straight> rest;
  std::vector<Range> taken;
  for (const Straight& piece : pieces) {
    taken.clear();
    boxes_of_others.any_near(piece.box(), together, [&](std::size_t i) {
      if (const Range range = common(piece, others[i]); !range.empty()) taken.push_back(range);
      return false;
    });
    std::sort(taken.begin(), taken.end(),
              [](const Range& a, const Range& b) { return a.from < b.from; });
    append_without(taken, piece, rest);
  }
  return rest;
}

}  // namespace streetgen
