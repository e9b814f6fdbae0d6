// Terrain with heights by a formula, for tests.
#pragma once

#include <cmath>

#include "streetgen/terrain.hpp"

namespace streetgen {

// Square of `cells` cells of 25 m with its lower left corner at the origin.
template <class Height>
Terrain made_terrain(Height height, int cells = 240) {
  HeightTile tile{0, cells * 25.0, 25, cells, cells, 0, {}};
  for (int row = 0; row < cells; ++row)
    for (int column = 0; column < cells; ++column)
      tile.heights.push_back(
          static_cast<float>(height(column * 25 + 12.5, cells * 25 - row * 25 - 12.5)));
  return Terrain::of({tile});
}

inline Zone rectangle_zone(double left, double bottom, double right, double top, int zone_class) {
  return {{{{{left, bottom}, {right, bottom}, {right, top}, {left, top}, {left, bottom}}}},
          zone_class};
}

}  // namespace streetgen
