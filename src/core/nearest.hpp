// The ground nearest to some of many sites.
#pragma once

#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

struct Site {
  Point point;
  bool first = true;  // belongs to the first of two owners
};

// The union of the Voronoi cells of the first owner's sites.  Of sites in one place (10
// micrometres) the earlier one counts.  Cells reach at least `far` metres beyond the sites.
MultiPolygon nearest_to_first(const std::vector<Site>& sites, double far);

}  // namespace streetgen
