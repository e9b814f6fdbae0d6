// An alignment as a line of chords.
#pragma once

#include <vector>

#include "streetgen/alignment.hpp"
#include "streetgen/vertical_alignment.hpp"

namespace streetgen {

// A line beside an alignment, such as that of one carriageway of two. It leaves the alignment at
// its ends, and has its offset (metres, to the left) after a taper, along a cubic without a corner.
struct LineOffset {
  double offset = 0, taper = 0;
};

// The part of an alignment between two abscissas, as chords that leave plan and heights by at most
// the tolerance (metres). Joints of elements and of grades are vertices. Without grades z is 0.
Line alignment_line(const std::vector<AlignmentElement>& elements,
                    const std::vector<GradePiece>& grades, double from, double to, double tolerance,
                    LineOffset beside = {});

}  // namespace streetgen
