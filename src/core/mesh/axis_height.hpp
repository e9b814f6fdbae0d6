// How high the roadway lies: the one place that says so.
#pragma once

#include <map>
#include <vector>

#include "geometry/box_index.hpp"
#include "streetgen/surface_mesh.hpp"

namespace streetgen {

// The axes must outlive it.
class AxisHeight {
 public:
  explicit AxisHeight(const std::vector<HeightAxis>& axes);

  // The height of the nearest place of the level's axes, of equal ones the lower; 0 without axes.
  // The same for the same place, whoever asks.
  double at(const Point& place, int level) const;

 private:
  struct Segment {
    Point from, to;
  };
  struct Level {
    std::vector<Segment> segments;
    BoxIndex index;
  };
  std::map<int, Level> levels_;
};

}  // namespace streetgen
