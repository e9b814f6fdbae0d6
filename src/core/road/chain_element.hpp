// Pieces of chains and elements of alignments are the same thing.
#pragma once

#include "streetgen/alignment.hpp"
#include "streetgen/plan_view.hpp"

namespace streetgen {

inline AlignmentElement element_of(const PlanPiece& piece) {
  return {piece.s,      piece.start.point, piece.start.heading,
          piece.length, piece.curvature,   piece.curvature_end};
}

inline PlanPiece piece_of(const AlignmentElement& element) {
  return {element.abscissa,
          {{element.start.x, element.start.y, 0}, element.heading},
          element.length,
          element.curvature_start,
          element.curvature_end};
}

}  // namespace streetgen
