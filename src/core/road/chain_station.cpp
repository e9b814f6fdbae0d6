#include <algorithm>
#include <cmath>
#include <cstddef>

#include "geometry/polyline.hpp"
#include "road/chain_element.hpp"
#include "road/road_piece.hpp"
#include "streetgen/error.hpp"
#include "streetgen/plan_view.hpp"
#include "support/infinite.hpp"

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

// Metres along a clothoid to its place that is nearest.
double nearest_on_clothoid(const PlanPiece& piece, const Point& p) {
  constexpr int looks = 16, halvings = 60;
  const AlignmentElement element = element_of(piece);
  const auto ahead = [&](double at) {
    const AlignmentPlace place = element_place(element, at);
    const Point way{std::cos(place.heading), std::sin(place.heading), 0};
    return dot(p - planar(place.point), way);
  };
  const auto off = [&](double at) { return distance(planar(element_place(element, at).point), p); };
  double nearest = 0, least = off(0);
  for (int i = 1; i <= looks; ++i)
    if (const double at = piece.length * i / looks; off(at) < least) least = off(at), nearest = at;
  double from = std::max(0.0, nearest - piece.length / looks);
  double to = std::min(piece.length, nearest + piece.length / looks);
  if (ahead(from) <= 0) return from;
  if (ahead(to) >= 0) return to;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (from + to) / 2;
    (ahead(middle) > 0 ? from : to) = middle;
  }
  return from;
}

}  // namespace

ChainStation station_of(const std::vector<PlanPiece>& chain, const Point& point) {
  if (chain.empty()) throw Error(ErrorKind::degenerate, "a chain without a piece has no station");
  const Point place = planar(point);
  double least = infinite;
  ChainStation found;
  for (const PlanPiece& piece : chain) {
    // No place of the piece is as near.
    if (distance(piece.start.point, place) - piece.length >= least) continue;
    const bool clothoid = piece.curvature != piece.curvature_end;
    const double at =
        clothoid ? nearest_on_clothoid(piece, place) : road_piece_of(piece).nearest(place);
    const AlignmentPlace there = element_place(element_of(piece), at);
    const Point off = place - planar(there.point);
    if (norm(off) >= least) continue;
    least = norm(off);
    const double heading = there.heading;
    const Point on{std::cos(heading), std::sin(heading), 0};
    found = {piece.s + at, dot(off, left_normal(on)), heading, dot(off, on)};
  }
  const bool at_an_end = found.s <= 0 || found.s >= length(chain);
  if (!at_an_end) found.beyond = 0;
  return found;
}

}  // namespace streetgen
