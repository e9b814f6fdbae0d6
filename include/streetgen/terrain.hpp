// Ground: heights from raster tiles, and zones that roads pay for, bridge or keep out of.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

// A tile of heights. Rows run from the top (greatest y) down, as in rasters; NaN is no data.
struct HeightTile {
  double x = 0, y = 0;  // upper left corner, metres
  double cell = 0;      // side of a square cell, metres
  int width = 0, height = 0;
  int srid = 0;
  std::vector<float> heights;
};

// A tile from raster WKB, as ST_AsBinary of postgis_raster and raster2pgsql write it: first band,
// any type of pixel. Refused (invalid_input): other bytes, cells that are not square or are turned,
// no band, heights beyond 100,000 m, and -9999, -32767 or -32768 where no value for missing heights
// is named.
HeightTile read_height_tile(std::string_view wkb);

// Heights of the ground, bilinear between the centres of cells.
class Terrain {
 public:
  struct Ground {
    double height = 0;                // NaN where there is none
    double slope_x = 0, slope_y = 0;  // rise over run
  };

  // Refused (invalid_input): tiles with another cell than the first or off its grid, tiles that
  // overlap, and extents of more than 400 million cells. No tile is a terrain without heights.
  static Terrain of(const std::vector<HeightTile>& tiles);

  // The half cell within the rim of the tiles has the slope of the cell beside it.
  Ground ground(double x, double y) const;
  double cell() const { return cell_; }

 private:
  double x_ = 0, y_ = 0, cell_ = 1;  // centre of the upper left cell
  int width_ = 0, height_ = 0;
  std::vector<float> heights_;
};

// The ways in which a road may cross a zone.
enum class Passage { free, bridge, forbidden };

struct ZoneClass {
  double cost = 0;  // for each square metre crossed
  Passage passage = Passage::free;
};

struct Zone {
  MultiPolygon surface;
  int zone_class = 0;  // index into the classes
};

// Zones on a grid: a cell that a zone touches belongs to the zone. Where several do, the strictest
// passage wins, then the greatest cost.
class ZoneGrid {
 public:
  ZoneGrid() = default;
  ZoneGrid(const std::vector<Zone>& zones, std::vector<ZoneClass> classes, double cell);
  // The class at a place; null outside of all zones.
  const ZoneClass* at(double x, double y) const {
    const double column = (x - x_) / cell_, row = (y - y_) / cell_;
    if (!(column >= 0 && row >= 0 && column < width_ && row < height_)) return nullptr;
    const std::uint8_t k =
        cells_[static_cast<std::size_t>(row) * width_ + static_cast<int>(column)];
    return k == 0 ? nullptr : &classes_[k - 1];
  }

  // Whether a straight line touches a cell of a forbidden zone.
  bool bars(const Point& from, const Point& to) const;

 private:
  void add(const Zone& zone);
  void put(double x, double y, std::uint8_t k);
  double x_ = 0, y_ = 0, cell_ = 1;
  int width_ = 0, height_ = 0;
  std::vector<std::uint8_t> cells_;
  std::vector<ZoneClass> classes_;
  bool any_forbidden_ = false;
};

}  // namespace streetgen
