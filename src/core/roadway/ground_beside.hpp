// The ground beside each edge: a median, a splitter, an island, or the city.
#pragma once

#include "layout/layout.hpp"
#include "streetgen/beside.hpp"

namespace streetgen {

// Lines, widths, directions and names of axes alone tell it, within the reach.
//
// A median lies between one-way edges of opposite directions that run side by side, no farther
// apart than median_width_maximal, kerb to kerb. Their names agree, or one has none. It may lie
// along a part of an edge; parts shorter than 15 m are as what they lie between, and the side of an
// edge is as more than half of it. Ground between the three sides of a small face is a splitter
// where a street parts into its two directions at one corner. Other small ground beside a one-way
// edge is an island, as all ground within a ring that its source names.
BesideEdges ground_beside(const Layout& layout);

}  // namespace streetgen
