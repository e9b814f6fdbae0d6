#include "surfaces.hpp"

#include <cmath>

#include "geometry/geos.hpp"

namespace streetgen::fuzz {

bool sound(const MultiPolygon& surface) {
  for (const Polygon& part : surface)
    for (const Ring& ring : part)
      for (const Point& p : ring)
        if (!std::isfinite(p.x) || !std::isfinite(p.y)) return false;
  Geos geos;
  return geos.valid(geos.surface(surface).get());
}

}  // namespace streetgen::fuzz
