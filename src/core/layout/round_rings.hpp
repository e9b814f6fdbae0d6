// Roundabouts as circles.
#pragma once

#include <vector>

#include "streetgen/network.hpp"
#include "streetgen/street.hpp"

namespace streetgen {

// Replaces the lines of edges on roundabouts by chords of an arc about the middle of the circle
// that fits all points of their axis, if that leaves none of the points of the edge by more than
// `shift`.  Nodes stay: an edge leads from the one to the other at a distance from the middle that
// changes evenly.  A line becomes a function of the points of its axis and of its nodes.
void round_rings(Network& network, const std::vector<StreetAxis>& axes, double shift);

}  // namespace streetgen
