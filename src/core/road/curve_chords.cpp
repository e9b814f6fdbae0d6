#include "road/curve_chords.hpp"

#include "geometry/polyline.hpp"
#include "streetgen/arc_road.hpp"

namespace streetgen {

namespace {
constexpr double leaves_arc = 1e-3;  // metres
}  // namespace

Line curve_chords(const CurvedLine& curve) {
  CurvedLine flat = curve;
  for (RingPiece& piece : flat)
    piece.arc = {planar(piece.arc.start), planar(piece.arc.middle), planar(piece.arc.end)};
  return distinct(ArcRoad::along(flat).line(leaves_arc));
}

}  // namespace streetgen
