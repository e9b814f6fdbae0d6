// Quads about the segments of a line and fans about its bends: their union is the ground where no
// ring holds.
#pragma once

#include <vector>

#include "geometry/geos.hpp"
#include "streetgen/geometry.hpp"

namespace streetgen {

// The sector from one place to another, counter-clockwise about a centre.
Polygon fan(const Point& centre, const Point& from, const Point& to);

// The half widths are those at each point of the line.  The first and the last quad end on `from`
// and `to`, where these are given.
MultiPolygon pieces(const Line& line, const std::vector<double>& left,
                    const std::vector<double>& right, const Line& from, const Line& to);

// A union of pieces with the ends of its border lines, where they lie on its boundary: pieces that
// meet there may differ by the noise of coordinates.
MultiPolygon ending_on(Geos& geos, MultiPolygon surface, const std::vector<Line>& borders);

// The union of quads, bends and discs: holds for any line.
MultiPolygon build_buffer(Geos& geos, const Line& line, const std::vector<double>& left,
                          const std::vector<double>& right, bool round_ends);

// The same with flat ends: the given borders (left, right along the line).
MultiPolygon build_between(Geos& geos, const Line& line, const std::vector<double>& left,
                           const std::vector<double>& right, const Line& from, const Line& to);

}  // namespace streetgen
