// Roundabouts as circles and smooth curves.
#pragma once

#include <vector>

#include "streetgen/network.hpp"
#include "streetgen/street.hpp"

namespace streetgen {

// Replaces the lines of edges on roundabouts by chords of an arc about the middle of the circle
// that fits all points of their axis, if that leaves none of the points of the edge by more than
// `shift`.  Nodes stay: an edge leads from the one to the other at a distance from the middle that
// changes evenly.  Where it would, the line becomes a smooth curve through its points instead, if
// that leaves none of its segments by more: an oval keeps its points.  A line becomes a function of
// the points of its axis and of its nodes.
void round_rings(Network& network, const std::vector<StreetAxis>& axes, double shift);

}  // namespace streetgen
