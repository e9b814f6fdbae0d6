// Raster WKB: the serialisation that PostGIS calls RFC2-WellKnownBinaryFormat.
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "streetgen/error.hpp"
#include "streetgen/terrain.hpp"

namespace streetgen {
namespace {

[[noreturn]] void refuse_raster(const std::string& what, const std::string& hint = "") {
  throw Error(ErrorKind::invalid_input, "a tile of heights " + what, hint);
}

class RasterReader {
 public:
  explicit RasterReader(std::string_view bytes) : bytes_(bytes) {
    little_ = take<std::uint8_t>() == 1;
  }

  template <class Number>
  Number take() {
    if (bytes_.size() - at_ < sizeof(Number)) refuse_raster("ends too early");
    unsigned char raw[sizeof(Number)];
    for (std::size_t i = 0; i < sizeof(Number); ++i)
      raw[little_ ? i : sizeof(Number) - 1 - i] = bytes_[at_ + i];
    at_ += sizeof(Number);
    Number number;
    std::memcpy(&number, raw, sizeof(Number));
    return number;
  }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
  bool little_ = true;
};

double take_pixel(RasterReader& reader, int type) {
  switch (type) {
    case 0:
    case 1:
    case 2:
    case 4:
      return reader.take<std::uint8_t>();
    case 3:
      return reader.take<std::int8_t>();
    case 5:
      return reader.take<std::int16_t>();
    case 6:
      return reader.take<std::uint16_t>();
    case 7:
      return reader.take<std::int32_t>();
    case 8:
      return reader.take<std::uint32_t>();
    case 10:
      return reader.take<float>();
    case 11:
      return reader.take<double>();
    default:
      refuse_raster("has pixels of unknown type " + std::to_string(type));
  }
}

// Files write such values where they know no height.
bool stands_for_none(double height) {
  return height == -9999 || height == -32767 || height == -32768;
}

void read_header(RasterReader& reader, HeightTile& tile) {
  if (const int version = reader.take<std::uint16_t>(); version != 0)
    refuse_raster("is raster WKB of unknown version " + std::to_string(version));
  const int bands = reader.take<std::uint16_t>();
  const double scale_x = reader.take<double>(), scale_y = reader.take<double>();
  tile.x = reader.take<double>();
  tile.y = reader.take<double>();
  const double skew_x = reader.take<double>(), skew_y = reader.take<double>();
  tile.srid = reader.take<std::int32_t>();
  tile.width = reader.take<std::uint16_t>();
  tile.height = reader.take<std::uint16_t>();
  if (bands < 1 || tile.width < 1 || tile.height < 1) refuse_raster("has no heights");
  if (!std::isfinite(tile.x) || !std::isfinite(tile.y) || !(scale_x > 0) ||
      !(std::abs(scale_x + scale_y) <= 1e-6 * scale_x) || skew_x != 0 || skew_y != 0)
    refuse_raster("has cells of " + text_of(scale_x) + " by " + text_of(scale_y) +
                      " that are not square, not upright, or turned",
                  "gdalwarp -tr makes them square.");
  tile.cell = scale_x;
}

}  // namespace

HeightTile read_height_tile(std::string_view wkb) {
  RasterReader reader(wkb);
  HeightTile tile;
  read_header(reader, tile);
  const int flags = reader.take<std::uint8_t>();
  const int type = flags & 15;
  if (flags & 128) refuse_raster("has its heights outside of the database", "Load them in-db.");
  const double no_data = take_pixel(reader, type);
  tile.heights.resize(static_cast<std::size_t>(tile.width) * tile.height);
  for (float& height : tile.heights) {
    const double read = take_pixel(reader, type);
    const bool named = (flags & 64) != 0;
    const bool none = (named && read == no_data) || std::isnan(read);
    if (!none && !(std::abs(read) <= 1e5))
      refuse_raster("has a height of " + text_of(read), "Heights are metres, up to 100000.");
    if (!named && stands_for_none(read))
      refuse_raster(
          "has heights of " + text_of(read) + " and names no value for missing ones",
          "ST_SetBandNoDataValue names it for a raster, gdal_edit.py -a_nodata for a file.");
    height = none ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(read);
  }
  return tile;
}

}  // namespace streetgen
