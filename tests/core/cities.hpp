// Extents and options of cities to draw, and angles between their streets.
#pragma once

#include <cmath>
#include <vector>

#include "geometry/polyline.hpp"
#include "streetgen/virtual_city.hpp"

namespace streetgen {

inline constexpr CityExtent town{0, 0, 5000, 3500};
inline constexpr CityExtent paper{6560000, 5570000, 20000, 10000};

// Degrees between two directions, 0 to 180.
inline double angle(const Point& a, const Point& b) {
  return std::atan2(std::abs(cross(a, b)), dot(a, b)) * 180 / M_PI;
}

// Cities that differ in what their axes are made of.
inline std::vector<CityOptions> kinds() {
  CityOptions bent, full, wild;
  bent.bend = 12;
  full.bend = 6;
  full.roundabouts = 0.5;
  full.stretch = 400;
  full.one_way_pairs = 1;
  full.centres = {0.3, 0.4, 0.8, 0.7};
  wild.right_angles = 0;
  wild.angle_least = 30;
  wild.scatter = 1;
  wild.spacing_least = 60;
  wild.clearance = 10;
  wild.node_gap = 1;
  CityOptions rings = wild;
  rings.bend = 20;
  rings.roundabouts = 1;
  return {CityOptions{}, bent, full, wild, rings};
}

}  // namespace streetgen
