#include "geometry/surface_union.hpp"

#include <algorithm>

#include "geometry/arrangement.hpp"
#include "geometry/prepared_surface.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

// So many parts of a node with ordinary streets meet few others; more about one point all meet, and
// their borders cross as often as there are pairs of them.
constexpr std::size_t at_once = 64;

}  // namespace

MultiPolygon united(Geos& geos, const std::vector<MultiPolygon>& parts) {
  if (parts.size() > at_once) {
    const auto middle = parts.begin() + parts.size() / 2;
    return united(geos,
                  {united(geos, {parts.begin(), middle}), united(geos, {middle, parts.end()})});
  }
  std::vector<LineView> lines;
  for (const MultiPolygon& part : parts)
    for (const Polygon& polygon : part) lines.insert(lines.end(), polygon.begin(), polygon.end());
  const Arrangement faces(lines);
  std::vector<bool> kept;
  for (const Point& place : faces.places()) {
    poll_cancel();
    kept.push_back(std::any_of(parts.begin(), parts.end(),
                               [&](const MultiPolygon& part) { return inside(place, part); }));
  }
  const MultiPolygon joined = faces.joined(kept);
  return geos.valid(joined) ? joined : faces.joined(kept, Arrangement::Vertices::on_grid);
}

}  // namespace streetgen
