// Texture coordinates: where a place of a surface is, seen from the line of the surface.
#pragma once

#include <array>

#include "streetgen/geometry.hpp"

namespace streetgen {

// Metres along the line to its nearest place, and to the left of it, in the plane. The line goes
// straight on at its ends. Of equal places the first one. A line without length gives metres to the
// east and north of its point.
std::array<double, 2> texture_place(const Line& line, const Point& place);

}  // namespace streetgen
