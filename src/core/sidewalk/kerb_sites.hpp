// Sites along two kerbs, from whose Voronoi cells the line halfway between the kerbs comes.
#pragma once

#include <vector>

#include "geometry/box.hpp"
#include "geometry/voronoi_border.hpp"
#include "streetgen/geometry.hpp"

namespace streetgen {

// As far as they come near the box. Each place of one kerb has a place of the other one across from
// it, as far from where the two kerbs would meet. So between straight kerbs the line is straight,
// however far apart the places are.
std::vector<Site> kerb_sites(const Line& first, const Line& second, const Box& within,
                             double margin);

}  // namespace streetgen
