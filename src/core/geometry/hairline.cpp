#include "geometry/hairline.hpp"

#include "geometry/closed_ring.hpp"
#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"

namespace streetgen {

namespace {

bool turns_back(const Point& before, const Point& tip, const Point& after) {
  return dot(tip - before, after - tip) < 0 &&
         (distance_to_segment(after, before, tip) <= same_place ||
          distance_to_segment(before, tip, after) <= same_place);
}

}  // namespace

Ring without_hairlines(const Ring& ring) {
  if (ring.empty()) return {};
  Ring left(ring.begin(), ring.end() - 1);
  for (std::size_t i = 0, kept = 0; left.size() > 2 && kept < left.size();) {
    const std::size_t last = left.size() - 1, before = i > 0 ? i - 1 : last;
    const Point &tip = left[i], &after = left[i < last ? i + 1 : 0];
    if (!turns_back(left[before], tip, after) && distance(tip, after) > sides_touch) {
      i = i < last ? i + 1 : 0;
      ++kept;
      continue;
    }
    left.erase(left.begin() + i);
    i = i > 0 ? i - 1 : left.size() - 1;
    kept = 0;
  }
  return closed(std::move(left));
}

}  // namespace streetgen
