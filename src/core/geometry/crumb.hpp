// Parts of a surface that are too small to keep.
#pragma once

#include <algorithm>
#include <utility>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "streetgen/geometry.hpp"

namespace streetgen {

inline MultiPolygon without_crumbs(MultiPolygon ground) {
  ground.erase(std::remove_if(ground.begin(), ground.end(),
                              [](const Polygon& part) { return area({part}) <= least_part; }),
               ground.end());
  return ground;
}

}  // namespace streetgen
