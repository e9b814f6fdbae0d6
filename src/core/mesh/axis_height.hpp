// The height of the roadway: the one place that says it.
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
  // An axis in whose roadway the place lies comes first, then the one of the nearest roadway. The
  // same for the same place, whoever asks.
  double at(const Point& place, int level) const { return nearest(place, level).height; }

  // Unit, upwards: normal to the nearest segment of the axes and level across it. The mean where
  // several are as near, as at a bend of the axis. Straight up without axes.
  Point normal(const Point& place, int level) const;

 private:
  struct Segment {
    Point from, to;
    double half_width;
    bool first, last;  // of its axis
  };
  struct Level {
    std::vector<Segment> segments;
    BoxIndex index;
  };
  // The place from which an axis sees another place.
  struct Sight {
    double beyond = 0;  // metres from the roadway
    double distance = 0, height = 0;
  };
  static Sight sight(const Segment& segment, const Point& place);
  Sight nearest(const Point& place, int level) const;

  std::map<int, Level> levels_;
};

}  // namespace streetgen
