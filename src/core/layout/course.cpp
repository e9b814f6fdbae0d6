#include "layout/course.hpp"

#include <algorithm>

#include "geometry/polyline.hpp"

namespace streetgen {

namespace {

Line part_of(const CoursePiece& piece, double from, double to) {
  const double span = piece.end - piece.start;
  const double share = span > 0 ? length(piece.line) / span : 0;
  return substring(piece.line, (from - piece.start) * share, (to - piece.start) * share);
}

KerbLine kerb_of(const CoursePiece& piece, double from, double to, int side) {
  if (piece.half > 0)
    return kerb_line(piece.line, from - piece.start, to - piece.start, piece.half, piece.half,
                     side);
  return {part_of(piece, from, to)};
}

}  // namespace

Course course_of(const Arm& arm, int side) {
  return {{arm.line, arm.start_to(side), 0, length(arm.line)}};
}

Line walked(const Course& course, double until) {
  Line line;
  for (const CoursePiece& piece : course) {
    if (piece.start > until) break;
    const Line part = part_of(piece, piece.start, std::min(until, piece.end));
    line.insert(line.end(), part.begin(), part.end());
  }
  return line;
}

Point direction_at(const Course& course, double abscissa) {
  const auto piece = std::find_if(course.begin(), course.end() - 1,
                                  [&](const CoursePiece& p) { return abscissa < p.end; });
  const double share = (abscissa - piece->start) / (piece->end - piece->start);
  return position_at(piece->line, share * length(piece->line)).direction;
}

KerbLine kerb_line(const Course& course, double u, double v, int side) {
  KerbLine kerb;
  for (const CoursePiece& piece : course) {
    const double from = std::max(std::min(u, v), piece.start);
    const double to = std::min(std::max(u, v), piece.end);
    if (from > to) continue;
    const KerbLine part = kerb_of(piece, from, to, side);
    kerb.line.insert(kerb.line.end(), part.line.begin(), part.line.end());
    kerb.whole = kerb.whole && part.whole;
  }
  if (u > v) kerb.line = reversed(std::move(kerb.line));
  return kerb;
}

}  // namespace streetgen
