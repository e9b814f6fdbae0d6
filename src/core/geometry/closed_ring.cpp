#include "geometry/closed_ring.hpp"

#include <algorithm>

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

}  // namespace streetgen
