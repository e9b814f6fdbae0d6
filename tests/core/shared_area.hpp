// Ground that two surfaces both hold: what surfaces that tile must not have.
#pragma once

#include "geometry/arrangement.hpp"
#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"

namespace streetgen {

inline double shared_area(const MultiPolygon& a, const MultiPolygon& b) {
  const PreparedSurface of_a(a), of_b(b);
  if (!overlap(of_a, of_b)) return 0;
  std::vector<LineView> lines;
  for (const MultiPolygon* surface : {&a, &b})
    for (const Polygon& part : *surface) lines.insert(lines.end(), part.begin(), part.end());
  const Arrangement faces(lines);
  std::vector<bool> both;
  for (const Point& place : faces.places()) both.push_back(of_a.holds(place) && of_b.holds(place));
  return area(faces.joined(both));
}

}  // namespace streetgen
