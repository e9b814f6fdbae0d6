// Ground that two surfaces both hold: what surfaces that tile must not have.
#pragma once

#include "../../src/core/geos.hpp"
#include "../../src/core/overlap.hpp"
#include "../../src/core/polyline.hpp"

namespace streetgen {

inline double shared_area(const MultiPolygon& a, const MultiPolygon& b) {
  const Ground of_a(a), of_b(b);
  if (!overlap(of_a, of_b)) return 0;
  Geos geos;
  std::vector<Line> lines;
  for (const MultiPolygon* surface : {&a, &b})
    for (const Polygon& part : *surface) lines.insert(lines.end(), part.begin(), part.end());
  double sum = 0;
  for (const Polygon& face : geos.faces(lines)) {
    const Point place = geos.place_inside(face);
    if (of_a.holds(place) && of_b.holds(place)) sum += area({face});
  }
  return sum;
}

}  // namespace streetgen
