// The height of a road as a polyline over metres along it.
#pragma once

#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

struct HeightPoint {
  double at = 0;  // metres along the road
  double z = 0;
};
using HeightLine = std::vector<HeightPoint>;  // ascending

HeightLine heights_of(const Line& line);
double height_at(const HeightLine& heights, double at);

// The line, and where the bound is higher the bound, which falls by the grade beyond its ends.
HeightLine raised_to(const HeightLine& heights, const HeightLine& bound, double grade);

// Without points at which the grade does not change.
HeightLine kinks_of(const HeightLine& heights);

HeightLine upside_down(HeightLine heights);

// The line with these heights: its points, and one at each further height point.
Line with_heights(const Line& line, const HeightLine& heights);

// At abscissa `at` a parabola may take so much, metres.
struct KinkLoss {
  double at = 0;
  double most = 0;
};

// The ways in which the road may leave its kinks.
struct KinkBounds {
  HeightLine ground;
  double radius = 0;          // metres, wanted
  std::vector<double> fixed;  // abscissas whose height stays
  // Kinks where a crest may lose height, since the road was lifted by that, and where a sag may
  // gain it, since the road was sunk by that.
  std::vector<KinkLoss> lowered, raised;
};

// Kinks off the ground become parabolas of the radius, or of a smaller one where the next kink or a
// fixed place is near.
HeightLine without_kinks(const HeightLine& heights, const KinkBounds& bounds);

}  // namespace streetgen
