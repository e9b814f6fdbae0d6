#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "made_terrain.hpp"
#include "streetgen/error.hpp"

namespace streetgen {
namespace terrain_test {

template <class Number>
void put(std::string& bytes, Number number) {
  char raw[sizeof(Number)];
  std::memcpy(raw, &number, sizeof raw);
  bytes.append(raw, sizeof raw);
}

// Raster WKB of 2 x 2 pixels of 16 bits, no data -1.
std::string small_raster(double scale_y = -10) {
  std::string bytes(1, '\1');
  put<std::uint16_t>(bytes, 0);
  put<std::uint16_t>(bytes, 1);
  for (double v : {10.0, scale_y, 100.0, 220.0, 0.0, 0.0}) put(bytes, v);
  put<std::int32_t>(bytes, 2154);
  put<std::uint16_t>(bytes, 2);
  put<std::uint16_t>(bytes, 2);
  bytes.push_back(static_cast<char>(64 | 5));
  for (std::int16_t v : {-1, 5, 7, 9, -1}) put(bytes, v);
  return bytes;
}

TEST(Terrain, ReadsRasterWkb) {
  const HeightTile tile = read_height_tile(small_raster());
  EXPECT_EQ(tile.srid, 2154);
  EXPECT_EQ(tile.width, 2);
  EXPECT_EQ(tile.heights[0], 5);
  EXPECT_TRUE(std::isnan(tile.heights[3]));
  EXPECT_THROW(read_height_tile(small_raster(-11)), Error);
  for (std::size_t n = 0; n < small_raster().size(); ++n)
    EXPECT_THROW(read_height_tile(small_raster().substr(0, n)), Error);
}

TEST(Terrain, APlaneIsReadExactly) {
  const Terrain plane = made_terrain([](double x, double y) { return 3 + 0.25 * x - 0.5 * y; });
  for (double x : {5.0, 1200.0, 3333.3, 5990.0})
    for (double y : {7.0, 2000.0, 5999.0}) {
      const Terrain::Ground g = plane.ground(x, y);
      EXPECT_NEAR(g.height, 3 + 0.25 * x - 0.5 * y, 1e-3);
      EXPECT_NEAR(g.slope_x, 0.25, 1e-4);
      EXPECT_NEAR(g.slope_y, -0.5, 1e-4);
    }
  EXPECT_TRUE(std::isnan(plane.ground(-1, 5).height));
}

TEST(Terrain, TilesThatOverlapOrDifferAreRefused) {
  const HeightTile a{0, 100, 10, 4, 4, 0, std::vector<float>(16, 1)};
  HeightTile b = a;
  EXPECT_THROW(Terrain::of({a, b}), Error);
  b.x = 40;
  EXPECT_NEAR(Terrain::of({a, b}).ground(40, 80).height, 1, 1e-9);
  b.x = 45;
  EXPECT_THROW(Terrain::of({a, b}), Error);
  b.x = 40, b.cell = 20;
  EXPECT_THROW(Terrain::of({a, b}), Error);
  b.cell = 10, b.x = 1e9;
  EXPECT_THROW(Terrain::of({a, b}), Error);
  EXPECT_TRUE(std::isnan(Terrain::of({}).ground(0, 0).height));
}

TEST(ZoneGrid, TheStricterZoneWins) {
  const ZoneGrid zones({rectangle_zone(0, 0, 100, 100, 0), rectangle_zone(50, 0, 150, 100, 1)},
                       {{7, Passage::free}, {0, Passage::bridge}}, 5);
  EXPECT_EQ(zones.at(25, 50)->passage, Passage::free);
  EXPECT_EQ(zones.at(75, 50)->passage, Passage::bridge);
  EXPECT_EQ(zones.at(200, 50), nullptr);
  EXPECT_EQ(ZoneGrid().at(0, 0), nullptr);
}

}  // namespace terrain_test
}  // namespace streetgen
