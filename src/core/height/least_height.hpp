// The least heights over the ground that keep grades and lifts.
#pragma once

#include <cstdint>
#include <vector>

#include "height/height_line.hpp"

namespace streetgen {

struct GradedRoad {
  std::int64_t from_node = 0;
  std::int64_t to_node = 0;
  HeightLine ground;          // at least two points
  double grade = 0;           // positive
  double grade_greatest = 0;  // the grade in a circle of lifts, if it is greater
  // Ground that the road left downwards before: there it rises only where its greatest grades
  // leave no other heights.  Empty: it did not.
  HeightLine left;
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

struct LeastHeights {
  std::vector<HeightLine> roads;
  std::vector<double> grades;  // that each road keeps
};

// The least heights of each road.  Roads of one node have one height there, the greatest of their
// grounds or more.  Where lifts raise each other without end, the roads of that circle get their
// greatest grades, and then the last lift is passed over.
LeastHeights least_heights(const std::vector<GradedRoad>& roads, const std::vector<Lift>& lifts,
                           const std::vector<LeastHeight>& by_hand);

}  // namespace streetgen
