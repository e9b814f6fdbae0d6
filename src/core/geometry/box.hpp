// Boxes with sides along the axes of the plane.
#pragma once

#include <algorithm>

#include "streetgen/geometry.hpp"
#include "support/infinite.hpp"

namespace streetgen {

// A box starts empty and holds no point until one is added.
struct Box {
  double min_x = infinite, min_y = min_x;
  double max_x = -min_x, max_y = -min_x;
  void add(const Point& p) {
    min_x = std::min(min_x, p.x);
    min_y = std::min(min_y, p.y);
    max_x = std::max(max_x, p.x);
    max_y = std::max(max_y, p.y);
  }
  bool empty() const { return min_x > max_x || min_y > max_y; }
  bool meets(const Box& o) const {
    return min_y <= o.max_y && o.min_y <= max_y && min_x <= o.max_x && o.min_x <= max_x;
  }
  bool meets(const Box& o, double margin) const {
    return min_x <= o.max_x + margin && o.min_x <= max_x + margin && min_y <= o.max_y + margin &&
           o.min_y <= max_y + margin;
  }
  Box grown(double margin) const {
    return {min_x - margin, min_y - margin, max_x + margin, max_y + margin};
  }
  bool holds(const Point& p, double margin) const {
    return p.x >= min_x - margin && p.x <= max_x + margin && p.y >= min_y - margin &&
           p.y <= max_y + margin;
  }
  // Squares of the distances from p to the nearest of it and to the farthest.
  double square_from(const Point& p) const {
    const double x = std::max({min_x - p.x, 0.0, p.x - max_x});
    const double y = std::max({min_y - p.y, 0.0, p.y - max_y});
    return x * x + y * y;
  }
  double farthest_square(const Point& p) const {
    const double x = std::max(p.x - min_x, max_x - p.x), y = std::max(p.y - min_y, max_y - p.y);
    return x * x + y * y;
  }
  Box joined_with(const Box& o) const {
    return {std::min(min_x, o.min_x), std::min(min_y, o.min_y), std::max(max_x, o.max_x),
            std::max(max_y, o.max_y)};
  }
  // What both hold; of boxes that do not meet, a box that holds nothing.
  Box shared_with(const Box& o) const {
    return {std::max(min_x, o.min_x), std::max(min_y, o.min_y), std::min(max_x, o.max_x),
            std::min(max_y, o.max_y)};
  }
};
inline Box box_of(const Point& a, const Point& b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y)};
}
Box box_of(const MultiPolygon& surface);

}  // namespace streetgen
