// Traffic islands: ground between streets that the fillets of its corners would swallow.
#pragma once

#include <vector>

#include "layout/layout.hpp"
#include "layout/node_corner.hpp"
#include "roadway/street_face.hpp"

namespace streetgen {

// By node, by gap.
using SolvedCorners = std::vector<std::vector<SolvedCorner>>;

// Whether a face whose flat kerbs leave room for a disc of 1 m loses that room, or over 15 % of the
// ground between the kerbs, to the fillets of its corners.
bool swallowed_island(const Layout& layout, const SolvedCorners& corners, const StreetFace& face);
// Whether the fillets leave ground between the kerbs of a face, but less than an island.
bool leaves_hole(const Layout& layout, const SolvedCorners& corners, const StreetFace& face);

}  // namespace streetgen
