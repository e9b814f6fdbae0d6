// Parts of a city for sessions that work beside each other (the StreetGen paper, figure 29).
#pragma once

#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

// The cluster, 1 to k, of each point: K-means by bisection, every cluster as large as the next one
// or one point larger.  A set is cut in two across its longest extent, then as Lloyd does: the two
// centres are found, and of all points those nearer to the first than to the second, as many as its
// half is to hold, go to the first; until none changes its side (at most 32 times).  Each half is
// cut the same way.  A cut is a straight line, so that the convex hulls of clusters share at most
// points that lie in one place or on the cut; clusters that follow each other lie near each other.
// Points in one place go by their order.  Throws Error{invalid_input} where k is not within 1 and
// the number of points.
std::vector<int> clusters(const std::vector<Point>& points, int k);

}  // namespace streetgen
