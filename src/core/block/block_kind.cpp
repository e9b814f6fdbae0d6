#include <cmath>

#include "block/block_kind.hpp"
#include "geometry/polyline.hpp"

namespace streetgen {

const char* block_kind_name(BlockKind kind) noexcept {
  switch (kind) {
    case BlockKind::block:
      return "block";
    case BlockKind::island:
      return "island";
    case BlockKind::strip:
      return "strip";
    case BlockKind::roadway:
      return "roadway";
  }
  return "";
}

BlockKind kind_of(const MultiPolygon& surface, const BlockSettings& settings, bool within_ring) {
  if (surface.empty()) return BlockKind::roadway;
  if (within_ring && settings.island_area > 0) return BlockKind::island;
  const double ground = area(surface);
  double about = 0;
  for (const Polygon& polygon : surface)
    for (const Ring& ring : polygon) about += length(ring);
  // Sides of the rectangle: their sum is half of its perimeter, their product its area.
  const double half = about / 2;
  const double apart = std::sqrt(std::max(0.0, half * half - 4 * ground));
  const double width = (half - apart) / 2, size = (half + apart) / 2;
  if (width <= settings.strip_width && size >= settings.strip_elongation * width)
    return BlockKind::strip;
  return ground < settings.island_area ? BlockKind::island : BlockKind::block;
}

}  // namespace streetgen
