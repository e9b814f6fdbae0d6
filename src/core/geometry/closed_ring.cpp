#include "geometry/closed_ring.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"

namespace streetgen {

Ring closed(Ring ring) {
  const auto together = [](const Point& p, const Point& q) {
    return distance(p, q) <= sides_touch;
  };
  ring.erase(std::unique(ring.begin(), ring.end(), together), ring.end());
  while (ring.size() > 1 && together(ring.back(), ring.front())) ring.pop_back();
  if (ring.size() < 3) return {};
  ring.push_back(ring.front());
  return ring;
}

bool has_closed_rings(const MultiPolygon& surface) {
  const auto is_closed = [](const Ring& ring) {
    return ring.size() > 3 && same(ring.front(), ring.back()) &&
           std::all_of(ring.begin(), ring.end(),
                       [](const Point& p) { return std::isfinite(p.x) && std::isfinite(p.y); });
  };
  return std::all_of(surface.begin(), surface.end(), [&](const Polygon& polygon) {
    return std::all_of(polygon.begin(), polygon.end(), is_closed);
  });
}

}  // namespace streetgen
