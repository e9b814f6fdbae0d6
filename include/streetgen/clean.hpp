// The filters of "GIS data to functional road models", section 3.4, on whole axes.
#pragma once

#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

// Removes points nearer than `epsilon` to the last kept one, then collinear points (all that go
// lie within 1e-3 m of the chord that replaces them), then points where r_min tan(theta / 2)
// exceeds half of either neighbouring segment (theta: the turn there).  Never the ends, nor a
// point i with keep[i], nor the end of a fold: a point that lies more than r_min beyond the chord
// that would replace it.
// A filter that would leave a closed line less than three sides is passed over.
// keep is empty or as long as the line (else Error{invalid_input}).  Lengths in metres.
Line clean(const Line& line, const std::vector<bool>& keep, double epsilon, double r_min);

// The lines of one network, each cleaned so with every point kept that another of them, or a line
// beside them, has within `tolerance`: a node may be there.
std::vector<Line> clean(const std::vector<Line>& lines, const std::vector<Line>& beside,
                        double tolerance, double epsilon, double r_min);

}  // namespace streetgen
