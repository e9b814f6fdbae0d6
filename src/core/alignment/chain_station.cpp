#include <cmath>
#include <cstddef>
#include <limits>

#include "alignment/road_piece.hpp"
#include "geometry/polyline.hpp"
#include "streetgen/error.hpp"
#include "streetgen/plan_view.hpp"

namespace streetgen {

namespace {

RoadPiece road_piece_of(const PlanPiece& piece) {
  RoadPiece road;
  road.origin = piece.start.point;
  road.forward = {std::cos(piece.start.heading), std::sin(piece.start.heading), 0};
  road.length = piece.length;
  if (piece.curvature == 0) return road;
  road.radius = 1 / std::abs(piece.curvature);
  road.inward = left_normal(road.forward) * (piece.curvature > 0 ? 1.0 : -1.0);
  return road;
}

}  // namespace

ChainStation station_of(const std::vector<PlanPiece>& chain, const Point& point) {
  if (chain.empty()) throw Error(ErrorKind::degenerate, "a chain without a piece has no station");
  const Point place = planar(point);
  double least = std::numeric_limits<double>::infinity();
  ChainStation found;
  for (const PlanPiece& piece : chain) {
    const RoadPiece road = road_piece_of(piece);
    const double at = road.nearest(place);
    const Point off = place - road.point(at);
    if (norm(off) >= least) continue;
    least = norm(off);
    const double heading = piece.start.heading + at * piece.curvature;
    const Point on{std::cos(heading), std::sin(heading), 0};
    found = {piece.s + at, dot(off, left_normal(on)), heading, dot(off, on)};
  }
  const bool at_an_end = found.s <= 0 || found.s >= length(chain);
  if (!at_an_end) found.beyond = 0;
  return found;
}

}  // namespace streetgen
