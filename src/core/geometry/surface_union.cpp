#include "geometry/surface_union.hpp"

#include <algorithm>

#include "geometry/arrangement.hpp"
#include "geometry/prepared_surface.hpp"

namespace streetgen {

MultiPolygon united(Geos& geos, const std::vector<MultiPolygon>& parts) {
  std::vector<LineView> lines;
  for (const MultiPolygon& part : parts)
    for (const Polygon& polygon : part) lines.insert(lines.end(), polygon.begin(), polygon.end());
  const Arrangement faces(lines);
  std::vector<bool> kept;
  for (const Point& place : faces.places())
    kept.push_back(std::any_of(parts.begin(), parts.end(),
                               [&](const MultiPolygon& part) { return inside(place, part); }));
  const MultiPolygon joined = faces.joined(kept);
  return geos.valid(joined) ? joined : faces.joined(kept, Arrangement::Vertices::on_grid);
}

}  // namespace streetgen
