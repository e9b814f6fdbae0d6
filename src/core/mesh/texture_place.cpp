#include "mesh/texture_place.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"
#include "support/infinite.hpp"

namespace streetgen {

std::array<double, 2> texture_place(const Line& line, const Point& place) {
  std::array<double, 2> best{place.x - line.front().x, place.y - line.front().y};
  double least = infinite, passed = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point along = line[i] - line[i - 1], off = place - line[i - 1];
    const double metres = norm(along);
    if (metres == 0) continue;
    const double ahead = dot(off, along) / metres, aside = cross(along, off) / metres;
    const double low = passed == 0 ? -infinite : 0;
    const double high = i + 1 == line.size() ? infinite : metres;
    const double foot = std::clamp(ahead, low, high);
    const double apart = std::hypot(ahead - foot, aside);
    if (apart < least) {
      least = apart;
      best = {passed + foot, aside < 0 ? -apart : apart};
    }
    passed += metres;
  }
  return best;
}

}  // namespace streetgen
