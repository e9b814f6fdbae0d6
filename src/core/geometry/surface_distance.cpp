#include "geometry/surface_distance.hpp"

#include <algorithm>
#include <vector>

#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"

namespace streetgen {

namespace {

struct BoxedSide {
  Point from, to;
  Box box;
};

std::vector<BoxedSide> sides_within(const MultiPolygon& surface, const Box& box) {
  std::vector<BoxedSide> sides;
  for (const Polygon& polygon : surface)
    for (const Ring& ring : polygon)
      for (std::size_t i = 1; i < ring.size(); ++i) {
        const BoxedSide side{ring[i - 1], ring[i], box_of(ring[i - 1], ring[i])};
        if (side.box.meets(box)) sides.push_back(side);
      }
  return sides;
}

// Sides that do not cross are nearest at an end.
bool come_near(const BoxedSide& a, const BoxedSide& b, double reach) {
  return a.box.meets(b.box, reach) && (crossing(a.from, a.to, b.from, b.to).has_value() ||
                                       distance_to_segment(a.from, b.from, b.to) <= reach ||
                                       distance_to_segment(a.to, b.from, b.to) <= reach ||
                                       distance_to_segment(b.from, a.from, a.to) <= reach ||
                                       distance_to_segment(b.to, a.from, a.to) <= reach);
}

// Of surfaces whose borders keep apart.
bool holds_part(const MultiPolygon& surface, const MultiPolygon& other) {
  return std::any_of(other.begin(), other.end(), [&](const Polygon& part) {
    const Point& place = part.front().front();
    return std::any_of(surface.begin(), surface.end(),
                       [&](const Polygon& polygon) { return inside(place, polygon); });
  });
}

}  // namespace

bool come_near(const MultiPolygon& a, const MultiPolygon& b, double reach) {
  const Box shared = box_of(a).grown(reach).shared_with(box_of(b).grown(reach));
  const std::vector<BoxedSide> of_a = sides_within(a, shared), of_b = sides_within(b, shared);
  const bool by_borders = std::any_of(of_a.begin(), of_a.end(), [&](const BoxedSide& side) {
    return std::any_of(of_b.begin(), of_b.end(),
                       [&](const BoxedSide& other) { return come_near(side, other, reach); });
  });
  return by_borders || holds_part(a, b) || holds_part(b, a);
}

}  // namespace streetgen
