// Parts of a surface that are too small to keep.
#pragma once

#include <algorithm>
#include <utility>

#include "polyline.hpp"
#include "streetgen/geometry.hpp"

namespace streetgen {

constexpr double crumb = 1e-6;  // square metres

inline MultiPolygon without_crumbs(MultiPolygon ground) {
  ground.erase(std::remove_if(ground.begin(), ground.end(),
                              [](const Polygon& part) { return area({part}) <= crumb; }),
               ground.end());
  return ground;
}

}  // namespace streetgen
