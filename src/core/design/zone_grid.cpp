#include <algorithm>
#include <cmath>

#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"
#include "streetgen/terrain.hpp"

namespace streetgen {
namespace {

constexpr double most_zone_cells = 1e8;

// The places where a row at height y enters and leaves a surface.
std::vector<double> row_crossings(const MultiPolygon& surface, double y) {
  std::vector<double> xs;
  for (const Polygon& polygon : surface)
    for (const Ring& ring : polygon)
      for (std::size_t i = 1; i < ring.size(); ++i) {
        const Point &a = ring[i - 1], &b = ring[i];
        if ((a.y > y) != (b.y > y)) xs.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
      }
  std::sort(xs.begin(), xs.end());
  return xs;
}

}  // namespace

ZoneGrid::ZoneGrid(const std::vector<Zone>& zones, std::vector<ZoneClass> classes, double cell)
    : cell_(cell), classes_(std::move(classes)) {
  double left = 1e300, bottom = 1e300, right = -1e300, top = -1e300;
  for (const Zone& zone : zones)
    for (const Polygon& polygon : zone.surface)
      for (const Ring& ring : polygon)
        for (const Point& p : ring) {
          left = std::min(left, p.x), right = std::max(right, p.x);
          bottom = std::min(bottom, p.y), top = std::max(top, p.y);
        }
  if (!(left <= right)) return;
  if (classes_.size() > 250)
    throw Error(ErrorKind::invalid_input, std::to_string(classes_.size()) + " classes of zones",
                "No more than 250 are told apart.");
  cell_ =
      std::max(cell, std::sqrt((right - left + cell) * (top - bottom + cell) / most_zone_cells));
  x_ = left - cell_;
  y_ = bottom - cell_;
  width_ = static_cast<int>((right - x_) / cell_) + 2;
  height_ = static_cast<int>((top - y_) / cell_) + 2;
  cells_.assign(static_cast<std::size_t>(width_) * height_, 0);
  for (const Zone& zone : zones) {
    add(zone);
    any_forbidden_ = any_forbidden_ || classes_[zone.zone_class].passage == Passage::forbidden;
  }
}

bool ZoneGrid::bars(const Point& from, const Point& to) const {
  if (!any_forbidden_) return false;
  // Cell by cell, over the side that the line leaves each by.
  const double dx = (to.x - from.x) / cell_, dy = (to.y - from.y) / cell_;
  double column = std::floor((from.x - x_) / cell_), row = std::floor((from.y - y_) / cell_);
  const double u = (from.x - x_) / cell_ - column, v = (from.y - y_) / cell_ - row;
  double next_column = dx > 0 ? (1 - u) / dx : dx < 0 ? -u / dx : 2;
  double next_row = dy > 0 ? (1 - v) / dy : dy < 0 ? -v / dy : 2;
  for (;;) {
    const ZoneClass* zone = at(x_ + (column + 0.5) * cell_, y_ + (row + 0.5) * cell_);
    if (zone != nullptr && zone->passage == Passage::forbidden) return true;
    if (std::min(next_column, next_row) > 1) return false;
    if (next_column < next_row) {
      column += std::copysign(1, dx);
      next_column += 1 / std::abs(dx);
    } else {
      row += std::copysign(1, dy);
      next_row += 1 / std::abs(dy);
    }
  }
}

void ZoneGrid::put(double x, double y, std::uint8_t k) {
  std::uint8_t& cell = cells_[static_cast<std::size_t>((y - y_) / cell_) * width_ +
                              static_cast<std::size_t>((x - x_) / cell_)];
  const auto stricter = [&](const ZoneClass& a, const ZoneClass& b) {
    return a.passage != b.passage ? a.passage > b.passage : a.cost > b.cost;
  };
  if (cell == 0 || stricter(classes_[k - 1], classes_[cell - 1])) cell = k;
}

void ZoneGrid::add(const Zone& zone) {
  poll_cancel();
  const auto k = static_cast<std::uint8_t>(zone.zone_class + 1);
  double bottom = 1e300, top = -1e300;
  for (const Polygon& polygon : zone.surface)
    for (const Ring& ring : polygon)
      for (std::size_t i = 1; i < ring.size(); ++i) {
        const Point &a = ring[i - 1], &b = ring[i];
        bottom = std::min(bottom, a.y), top = std::max(top, a.y);
        const double steps = std::ceil(std::hypot(b.x - a.x, b.y - a.y) / cell_ * 2) + 1;
        for (double t = 0; t <= steps; ++t)
          put(a.x + t / steps * (b.x - a.x), a.y + t / steps * (b.y - a.y), k);
      }
  const double first = std::floor((bottom - y_) / cell_);
  for (double y = y_ + (first + 0.5) * cell_; y <= top; y += cell_) {
    const std::vector<double> xs = row_crossings(zone.surface, y);
    for (std::size_t i = 0; i + 1 < xs.size(); i += 2)
      for (double x = x_ + (std::ceil((xs[i] - x_) / cell_ - 0.5) + 0.5) * cell_; x <= xs[i + 1];
           x += cell_)
        put(x, y, k);
  }
}

}  // namespace streetgen
