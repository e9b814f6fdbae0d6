// The least heights over the ground that keep grades and lifts.
#pragma once

#include <cstdint>
#include <vector>

#include "height/height_line.hpp"

namespace streetgen {

struct GradedRoad {
  std::int64_t from_node = 0;
  std::int64_t to_node = 0;
  HeightLine ground;  // at least two points
  double grade = 0;   // positive
};

// The place `to` lies at least `rise` above the place `from`.
struct Lift {
  int from = 0;  // index of a road
  double from_at = 0;
  int to = 0;
  double to_at = 0;
  double rise = 0;
};

// The road lies at least so high there.
struct LeastHeight {
  int road = 0;
  double at = 0;
  double z = 0;
};

// The least heights of each road.  Roads of one node have one height there, the greatest of their
// grounds or more. Of
// lifts that raise each other without end the last one is passed over.
std::vector<HeightLine> least_heights(const std::vector<GradedRoad>& roads,
                                      const std::vector<Lift>& lifts,
                                      const std::vector<LeastHeight>& by_hand);

}  // namespace streetgen
