// Alignments as arrays of numbers: elements as seven each (abscissa, x, y, heading, length and the
// two curvatures), grade points as three (abscissa, height, radius).
#pragma once

#include <vector>

#include "streetgen/alignment.hpp"
#include "streetgen/vertical_alignment.hpp"
#include "value/number_array.hpp"

namespace streetgen::pg {

std::vector<AlignmentElement> elements_of(const NumberArray& array);
std::vector<GradePoint> grade_points_of(const NumberArray& array);

}  // namespace streetgen::pg
