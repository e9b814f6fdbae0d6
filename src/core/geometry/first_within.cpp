#include "streetgen/first_within.hpp"

#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "geometry/grid_cell.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

struct CellHash {
  std::size_t operator()(const GridCell& cell) const {
    return static_cast<std::uint64_t>(cell.x) * 0x9e3779b97f4a7c15 ^
           static_cast<std::uint64_t>(cell.y) * 0x517cc1b727220a95;
  }
};

double apart(const Point& a, const Point& b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }

}  // namespace

std::vector<int> first_within(const std::vector<Point>& places,
                              const std::vector<std::int64_t>& groups, double reach) {
  // A cell is as wide as the reach, so that the cells around hold all that lies within.
  std::unordered_map<GridCell, std::vector<int>, CellHash> standing;
  std::vector<int> first(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    poll_cancel();
    const GridCell cell{static_cast<std::int64_t>(std::floor(places[i].x / reach)),
                        static_cast<std::int64_t>(std::floor(places[i].y / reach))};
    first[i] = static_cast<int>(i);
    double least = reach;
    for (std::int64_t dx = -1; dx <= 1; ++dx)
      for (std::int64_t dy = -1; dy <= 1; ++dy) {
        const auto there = standing.find({cell.x + dx, cell.y + dy});
        if (there == standing.end()) continue;
        for (const int k : there->second) {
          if (groups[i] != 0 && groups[i] != groups[k]) continue;
          const double here = apart(places[i], places[k]);
          if (here < least) least = here, first[i] = k;
        }
      }
    if (first[i] == static_cast<int>(i)) standing[cell].push_back(static_cast<int>(i));
  }
  return first;
}

}  // namespace streetgen
