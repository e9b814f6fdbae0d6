// Places along the pieces of a link.
#pragma once

#include <algorithm>
#include <cmath>

#include "streetgen/traffic.hpp"

namespace streetgen {

// The last row that begins at or before a place, else the first one.
template <class Row>
const Row* row_at(const Row* first, const Row* last, double metres) {
  const Row* const after = std::upper_bound(
      first, last, metres, [](double m, const Row& row) { return m < row.metres; });
  return after == first ? after : after - 1;
}

inline double course_length(const Link& link) { return link.length * link.stretch; }

struct CoursePlace {
  double x = 0, y = 0, heading = 0, curvature = 0;
};

// Metres after a piece begins.
inline CoursePlace place_on(const LinkPiece& piece, double along) {
  const double half_turn = piece.curvature * along / 2;
  const double chord = piece.curvature == 0 ? along : 2 * std::sin(half_turn) / piece.curvature;
  return {piece.x + chord * std::cos(piece.heading + half_turn),
          piece.y + chord * std::sin(piece.heading + half_turn), piece.heading + 2 * half_turn,
          piece.curvature};
}

}  // namespace streetgen
