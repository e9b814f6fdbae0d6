// Loops of raw borders, which an inner bend turns over beside a road.
#pragma once

#include <cstddef>
#include <vector>

#include "road/road_piece.hpp"

namespace streetgen {

// A piece of a border before loops are cut out.
struct RawBorderPiece {
  RoadPiece piece;
  std::size_t of = 0;        // the piece of the road that it lies beside
  bool turned_over = false;  // an inner bend that is tighter than the offset made it
};

// A part of a border that stays; each starts where the one before it ends.
struct BorderPart {
  std::size_t index;  // of the piece
  double from, to;    // metres along it
};

// A loop goes out whose pieces all lie nearer to their part of the road than the offset and one of
// which is turned over; so does what is turned over at the ends. All in one plane. Where a border
// of chords crosses itself it may lie nearer than the offset by `slack`.
std::vector<BorderPart> without_bend_loops(const std::vector<RawBorderPiece>& border,
                                           const std::vector<RoadPiece>& road, double offset,
                                           double slack = 0);

}  // namespace streetgen
