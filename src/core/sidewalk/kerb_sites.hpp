// Sites along two kerbs, from whose Voronoi cells the line halfway between the kerbs comes.
#pragma once

#include <vector>

#include "geometry/voronoi_border.hpp"
#include "streetgen/geometry.hpp"

namespace streetgen {

// Of the places nearer than the reach to the other kerb. For each place of one kerb there is a
// place of the other kerb, and both are equally far from where the two kerbs would meet. So the
// line between straight kerbs is straight, however far apart the places are. A place that lies on
// both kerbs, where one follows the other, is no site.
std::vector<Site> kerb_sites(const Line& first, const Line& second, double reach);

}  // namespace streetgen
