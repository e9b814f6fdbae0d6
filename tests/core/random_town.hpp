// Towns far worse than real ones: streets at any angle, wide, crossing, overlapping.
#pragma once

#include <random>

#include "../../src/core/polyline.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {

inline std::vector<StreetAxis> random_town(unsigned seed, int count) {
  std::mt19937_64 random(seed);
  std::vector<Point> places;
  for (int i = 0; i < count / 2; ++i)
    places.push_back({650000 + random() % 4000 / 10.0, 6860000 + random() % 4000 / 10.0, 0});
  std::vector<StreetAxis> axes;
  for (int i = 0; i < count; ++i) {
    const Point &a = places[random() % places.size()], &b = places[random() % places.size()];
    if (distance(a, b) < 1) continue;
    StreetAxis axis;
    axis.axis_id = i + 1;
    axis.line = {a, b};
    axis.width = axis.width_end = 3 + random() % 120 / 10.0;
    axis.radius = random() % 80 / 10.0;
    axis.importance = 1 + random() % 5;
    axes.push_back(axis);
  }
  return axes;
}

}  // namespace streetgen
