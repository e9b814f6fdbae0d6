// Edges as arc roads: the lines on which a car drives without a jump of heading.
#pragma once

#include "streetgen/network.hpp"
#include "streetgen/street.hpp"

namespace streetgen {

// Replaces the line of each edge by chords of its arc road. Nodes stay. Where two edges of one level
// go on from one another, both leave the node along the mean of their directions, so that the road
// has one tangent there. A line becomes a function of its own points and of the first segments of
// the edges that go on from it. Abscissas along the axis stay what they were.
void smooth_edges(Network& network, const Smoothing& smoothing);

}  // namespace streetgen
