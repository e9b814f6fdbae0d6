#include "design/town_grid.hpp"

#include "geometry/box.hpp"

namespace streetgen {

TownGrid::TownGrid(const std::vector<Point>& places) : places_(places) {
  Box box;
  for (const Point& p : places) box.add(p);
  if (!box.empty()) {
    left_ = box.min_x, bottom_ = box.min_y;
    const double wide = box.max_x - box.min_x, high = box.max_y - box.min_y;
    // Towns along a line have a box without area, and no more cells than towns.
    cell_ = std::max({std::sqrt(wide * high * towns_a_cell / places.size()),
                      std::max(wide, high) / places.size(), 1e-9});
    columns_ = static_cast<int>(wide / cell_) + 1;
    rows_ = static_cast<int>(high / cell_) + 1;
  }
  cells_.resize(static_cast<std::size_t>(columns_) * rows_);
  for (std::size_t i = 0; i < places.size(); ++i)
    cells_[cell_of(places[i].y - bottom_, rows_) * columns_ +
           cell_of(places[i].x - left_, columns_)]
        .push_back(static_cast<int>(i));
}

}  // namespace streetgen
