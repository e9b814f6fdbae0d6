// Whether a surface about a node holds the arms that meet there.
#pragma once

#include <vector>

#include "layout/arm.hpp"

namespace streetgen {

// Axis and kerbs of every arm: the arc of two arms may cut a third one that leaves between them,
// and the kerbs of a short one may end beyond its neighbour's. Where the flat end of an arm reaches
// past its neighbours' axes, their kerbs hold, but beside an arm that goes on from it.
bool covers(const MultiPolygon& surface, const std::vector<Arm>& arms,
            const std::vector<Gap>& gaps);

}  // namespace streetgen
