// The points of a polyline at which a road bends.
#pragma once

#include <cstddef>
#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

// The ends and what is neither repeated nor on the way between its neighbours.
struct RoadVertices {
  Line points;
  std::vector<std::size_t> numbers;  // indices in the line
};

// Refuses, as ArcRoad::fit does, points that are not finite, no length and vertical pieces.
RoadVertices road_vertices(const Line& line);

// Metres. Coordinates as great as those of the points are rounded by less.
double resolution(const Line& points);

// Refuses a piece that rises without going anywhere.
void refuse_vertical(const Point& from, const Point& to, const char* what, std::size_t number);

}  // namespace streetgen
