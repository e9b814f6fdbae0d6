// The arc of a corner as it is drawn.
#pragma once

#include "streetgen/corner.hpp"

namespace streetgen {

// From the left kerb of the first street to the right one of the second.
Line drawn_arc(const CornerArc& corner);

}  // namespace streetgen
