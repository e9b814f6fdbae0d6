// Towns in square cells, so that those between two of them are found without asking all.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "geometry/polyline.hpp"

namespace streetgen {

class TownGrid {
 public:
  explicit TownGrid(const std::vector<Point>& places);

  // Ground per town: the area of the box of all, over their count.
  double room() const { return cell_ * cell_ / towns_a_cell; }

  // Calls `use` with each town whose distances to two places sum to at most `sum`.
  template <class Use>
  void each_between(const Point& a, const Point& b, double sum, Use use) const {
    const double length = distance(a, b);
    if (!(sum >= length) || !(length > 0)) return;
    // The ellipse lies in a strip along the line, which is walked along its longer axis.
    const double width = std::sqrt(sum * sum - length * length) / 2;
    const bool flat = std::abs(b.x - a.x) >= std::abs(b.y - a.y);
    const double ax = flat ? a.x : a.y, ay = flat ? a.y : a.x;
    const double bx = flat ? b.x : b.y, by = flat ? b.y : b.x;
    const double slope = (by - ay) / (bx - ax), half = width * std::sqrt(1 + slope * slope);
    const double beyond = (sum - length) / 2;
    const int columns = flat ? columns_ : rows_, rows = flat ? rows_ : columns_;
    const double left = flat ? left_ : bottom_, low = flat ? bottom_ : left_;
    const int first = cell_of(std::min(ax, bx) - beyond - left, columns);
    const int last = cell_of(std::max(ax, bx) + beyond - left, columns);
    for (int i = first; i <= last; ++i) {
      const double y = ay + slope * (left + i * cell_ - ax), next = y + slope * cell_;
      const int from = cell_of(std::min(y, next) - half - low, rows);
      const int to = cell_of(std::max(y, next) + half - low, rows);
      for (int j = from; j <= to; ++j)
        for (int town : cells_[flat ? j * columns_ + i : i * columns_ + j]) {
          const Point& p = places_[town];
          if (distance(p, a) + distance(p, b) <= sum) use(static_cast<std::size_t>(town));
        }
    }
  }

 private:
  static constexpr double towns_a_cell = 2;
  int cell_of(double metres, int count) const {
    return static_cast<int>(std::clamp(std::floor(metres / cell_), 0.0, count - 1.0));
  }

  std::vector<Point> places_;
  double left_ = 0, bottom_ = 0, cell_ = 1;
  int columns_ = 1, rows_ = 1;
  std::vector<std::vector<int>> cells_;
};

}  // namespace streetgen
