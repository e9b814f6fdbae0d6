// A leg of a path: the way from one place to the next.
#pragma once

#include <optional>
#include <vector>

#include "design/search_layer.hpp"
#include "streetgen/road_design.hpp"

namespace streetgen {

// A side of the path that a leg should keep clear of.
struct PathSide {
  Point from, to;
};

struct PathLeg {
  std::optional<Line> line;  // with both places; none: something bars the way
  double cell = 0;           // of the grid that the line lies on; 0: it was not searched
  Barrier barrier = Barrier::none;
};

// The way of least cost whose turns fit the sides about it. Where that ties a loop, the way that is
// free of these sides, whose curves shrink; where that crosses one of the `others` as well, the
// straight side. What the straight side crosses the leg may cross, too.
PathLeg find_leg(const DesignSite& site, const Point& a, const Point& b, const SidesAbout& about,
                 const std::vector<PathSide>& others);

}  // namespace streetgen
