// Breaklines: edges of triangles that carry the heights of the axes into their surfaces.
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/border_net.hpp"

namespace streetgen {

// The line without the points that leave it, heights included, by at most the tolerance.
Line without_slight_bends(const Line& line, double tolerance);

// The parts of axes within a surface, and the lines across at their bends, to both borders.
struct Breaklines {
  std::vector<BorderNet::Segment> along, across;
};

// Adds those of an axis to those of a surface of the net. The sides that they meet are divided.
// Some may cross each other.
void add_breaklines(BorderNet& net, std::size_t surface, const MultiPolygon& ground,
                    const Line& axis, Breaklines& breaklines);

// Goes straight on to the border where an axis ends within the surface.
void end_at_border(BorderNet& net, std::size_t surface, const MultiPolygon& ground,
                   Breaklines& breaklines);

// The breaklines, the axes first, that meet neither each other nor the border but in common
// vertices.
std::vector<BorderNet::Segment> apart(const BorderNet& net,
                                      const std::vector<BorderNet::Segment>& border,
                                      const Breaklines& breaklines);

}  // namespace streetgen
