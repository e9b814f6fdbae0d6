// Towns far worse than real ones: streets at any angle, wide, crossing, overlapping.
#pragma once

#include <random>

#include "geometry/polyline.hpp"
#include "streetgen/street.hpp"

namespace streetgen {

inline std::vector<Point> random_places(std::mt19937_64& random, int count) {
  std::vector<Point> places;
  for (int i = 0; i < count; ++i)
    places.push_back({650000 + random() % 4000 / 10.0, 6860000 + random() % 4000 / 10.0, 0});
  return places;
}

inline std::vector<StreetAxis> random_town(unsigned seed, int count) {
  std::mt19937_64 random(seed);
  const std::vector<Point> places = random_places(random, count / 2);
  std::vector<StreetAxis> axes;
  for (int i = 0; i < count; ++i) {
    const Point &a = places[random() % places.size()], &b = places[random() % places.size()];
    if (distance(a, b) < 1) continue;
    const double width = 3 + random() % 120 / 10.0, radius = random() % 80 / 10.0;
    axes.push_back({i + 1, {a, b}, 0, width, width, radius, 1 + static_cast<int>(random() % 5)});
  }
  return axes;
}

}  // namespace streetgen
