// Sites along two kerbs, from whose Voronoi cells the line halfway between the kerbs comes.
#pragma once

#include <vector>

#include "geometry/box.hpp"
#include "geometry/voronoi_border.hpp"
#include "streetgen/geometry.hpp"

namespace streetgen {

// The sites lie within the margin of the box. For each place of one kerb there is a place of the
// other kerb, and both are equally far from where the two kerbs would meet. So the line between
// straight kerbs is straight, however far apart the places are.
std::vector<Site> kerb_sites(const Line& first, const Line& second, const Box& within,
                             double margin);

}  // namespace streetgen
