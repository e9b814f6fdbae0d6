#include "roadway/course.hpp"

#include <algorithm>

#include "geometry/polyline.hpp"

namespace streetgen {

namespace {

Line part_of(const Leg& leg, double from, double to) {
  const double span = leg.end - leg.start;
  const double share = span > 0 ? length(leg.line) / span : 0;
  return substring(leg.line, (from - leg.start) * share, (to - leg.start) * share);
}

Kerb kerb_of(const Leg& leg, double from, double to, int side) {
  if (leg.half > 0)
    return kerb_line(leg.line, from - leg.start, to - leg.start, leg.half, leg.half, side);
  return {part_of(leg, from, to)};
}

}  // namespace

Line walked(const Course& course, double until) {
  Line line;
  for (const Leg& leg : course) {
    if (leg.start > until) break;
    const Line part = part_of(leg, leg.start, std::min(until, leg.end));
    line.insert(line.end(), part.begin(), part.end());
  }
  return line;
}

Kerb kerb_line(const Course& course, double u, double v, int side) {
  Kerb kerb;
  for (const Leg& leg : course) {
    const double from = std::max(std::min(u, v), leg.start);
    const double to = std::min(std::max(u, v), leg.end);
    if (from > to) continue;
    const Kerb part = kerb_of(leg, from, to, side);
    kerb.line.insert(kerb.line.end(), part.line.begin(), part.line.end());
    kerb.whole = kerb.whole && part.whole;
  }
  if (u > v) kerb.line = reversed(std::move(kerb.line));
  return kerb;
}

}  // namespace streetgen
