#include "streetgen/terrain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"

namespace streetgen {
namespace {

constexpr double most_cells = 4e8;
constexpr float no_height = std::numeric_limits<float>::quiet_NaN();

std::string place_of(const HeightTile& tile) {
  return "the tile at " + text_of(tile.x) + ", " + text_of(tile.y);
}

// Cells between two places of one grid; other places are refused.
int cells_between(double from, double to, const HeightTile& tile) {
  const double cells = (to - from) / tile.cell;
  if (std::abs(cells - std::round(cells)) > 0.01)
    throw Error(ErrorKind::invalid_input, place_of(tile) + " lies off the grid of the others",
                "Cut all tiles from one raster.");
  return static_cast<int>(std::round(cells));
}

}  // namespace

Terrain Terrain::of(const std::vector<HeightTile>& tiles) {
  Terrain terrain;
  if (tiles.empty()) return terrain;
  const double cell = tiles[0].cell;
  double left = tiles[0].x, top = tiles[0].y, right = left, bottom = top;
  for (const HeightTile& tile : tiles) {
    if (std::abs(tile.cell - cell) > 1e-6 * cell)
      throw Error(ErrorKind::invalid_input,
                  place_of(tile) + " has cells of " + text_of(tile.cell) + " m, others have " +
                      text_of(cell) + " m",
                  "Cut all tiles from one raster.");
    left = std::min(left, tile.x);
    top = std::max(top, tile.y);
    right = std::max(right, tile.x + tile.width * cell);
    bottom = std::min(bottom, tile.y - tile.height * cell);
  }
  const double columns = std::round((right - left) / cell),
               rows = std::round((top - bottom) / cell);
  if (columns * rows > most_cells)
    throw Error(ErrorKind::invalid_input,
                "the terrain spans " + text_of(columns) + " by " + text_of(rows) + " cells",
                "Load tiles of the area that is designed, or of wider cells.");
  terrain.cell_ = cell;
  terrain.x_ = left + cell / 2;
  terrain.y_ = top - cell / 2;
  terrain.width_ = static_cast<int>(columns);
  terrain.height_ = static_cast<int>(rows);
  terrain.heights_.assign(static_cast<std::size_t>(columns) * rows, no_height);
  std::vector<bool> taken(terrain.heights_.size(), false);
  for (const HeightTile& tile : tiles) {
    poll_cancel();
    const int column = cells_between(left, tile.x, tile), row = cells_between(tile.y, top, tile);
    for (int j = 0; j < tile.height; ++j)
      for (int i = 0; i < tile.width; ++i) {
        const std::size_t k = static_cast<std::size_t>(row + j) * terrain.width_ + column + i;
        if (taken[k])
          throw Error(ErrorKind::invalid_input, place_of(tile) + " overlaps another",
                      "Delete one of both.");
        taken[k] = true;
        terrain.heights_[k] = tile.heights[static_cast<std::size_t>(j) * tile.width + i];
      }
  }
  return terrain;
}

Terrain::Ground Terrain::ground(double x, double y) const {
  const double column = (x - x_) / cell_, row = (y_ - y) / cell_;
  // A place on the rim is within; the half cell beyond the last centres continues its neighbour.
  if (!(column >= -0.5 && row >= -0.5 && column <= width_ - 0.5 && row <= height_ - 0.5))
    return {no_height, 0, 0};
  const int i = std::clamp(static_cast<int>(std::floor(column)), 0, std::max(0, width_ - 2));
  const int j = std::clamp(static_cast<int>(std::floor(row)), 0, std::max(0, height_ - 2));
  const int right = width_ > 1 ? 1 : 0, down = height_ > 1 ? width_ : 0;
  const float* h = &heights_[static_cast<std::size_t>(j) * width_ + i];
  const double a = h[0], b = h[right], c = h[down], d = h[down + right];
  const double u = column - i, v = row - j;
  return {a + (b - a) * u + (c - a) * v + (a - b - c + d) * u * v,
          ((b - a) + (a - b - c + d) * v) / cell_, -((c - a) + (a - b - c + d) * u) / cell_};
}

}  // namespace streetgen
