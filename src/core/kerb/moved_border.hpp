// The sides of borders that came or went with a change.
#pragma once

#include <array>
#include <set>
#include <utility>
#include <vector>

#include "geometry/box_index.hpp"
#include "streetgen/geometry.hpp"

namespace streetgen {

// Surfaces before and after: a side that both have on one level did not move.
class MovedBorder {
 public:
  void toggle(const MultiPolygon& surface, int level);
  // After the last of them.
  void settle();
  // Whether a side of the surface lies along one that came or went.
  bool lies_along(const MultiPolygon& surface) const;

 private:
  std::set<std::array<double, 5>> sides_;
  std::vector<std::pair<Point, Point>> moved_;
  BoxIndex index_;
};

}  // namespace streetgen
