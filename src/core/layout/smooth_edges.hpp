// Edges as arc roads: the lines on which a car drives without a jump of heading.
#pragma once

#include <vector>

#include "streetgen/network.hpp"
#include "streetgen/road.hpp"
#include "streetgen/street.hpp"

namespace streetgen {

// A line in the place of another one, with its heights, at the same share of the length.
Line with_heights(Line drawn, const Line& line);

// Gives each edge its arc road, and replaces its line by chords of that. Nodes stay. A line becomes
// a function of its own points, of overrides of its axis, and of the first segments of the edges
// that go on from it. Abscissas along the axis stay what they were.
void smooth_edges(Network& network, const Smoothing& smoothing,
                  const std::vector<RoadOverride>& overrides);

}  // namespace streetgen
