#include "geometry/fill_holes.hpp"

#include <cmath>

#include "geometry/polyline.hpp"

namespace streetgen {

void fill_holes(MultiPolygon& surface, double max_area) {
  for (Polygon& polygon : surface)
    for (std::size_t i = polygon.size() - 1; i > 0; --i)
      if (std::abs(signed_area(polygon[i])) < max_area) polygon.erase(polygon.begin() + i);
}

}  // namespace streetgen
