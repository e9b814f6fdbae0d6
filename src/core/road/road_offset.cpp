// The road at an offset: ArcRoad::offset.
#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/space.hpp"
#include "geometry/tolerance.hpp"
#include "road/bend_loop.hpp"
#include "road/fit_radii.hpp"
#include "road/road_body.hpp"
#include "streetgen/error.hpp"

namespace streetgen {

namespace {

// A piece beside one of the road. An arc that is tighter than the offset runs back, beyond its
// centre.
RoadPiece beside(const RoadPiece& piece, double offset) {
  RoadPiece moved = piece;
  moved.origin = piece.origin + leftwards(piece.forward) * offset;
  if (!piece.curved()) return moved;
  const double radius = turn_of(piece) > 0 ? piece.radius - offset : piece.radius + offset;
  moved.radius = std::abs(radius);
  moved.length = piece.angle() * moved.radius;
  if (radius < 0) {
    moved.forward = piece.forward * -1;
    moved.inward = piece.inward * -1;
  }
  return moved;
}

// Between two pieces that meet at a sharp bend: round about it outside, straight across inside.
RawBorderPiece join_at(const RoadPiece& before, const RoadPiece& after, double offset) {
  const Point in = before.direction(before.length), out = after.forward;
  const Point from = after.origin + leftwards(in) * offset;
  const Point to = after.origin + leftwards(out) * offset;
  const bool back = dot(in, out) < 0 && std::abs(cross(in, out)) <= straight_sine;
  RawBorderPiece join;
  if (back || cross(in, out) * offset < 0) {
    join.piece.origin = from;
    join.piece.forward = in;
    join.piece.inward = leftwards(in) * (offset > 0 ? -1 : 1);
    join.piece.radius = std::abs(offset);
    join.piece.length = join.piece.radius * std::atan2(std::abs(cross(in, out)), dot(in, out));
  } else {
    join.piece = straight_piece(from, to);
    join.turned_over = true;
  }
  return join;
}

std::vector<RawBorderPiece> raw_border(const std::vector<RoadPiece>& road, double offset) {
  std::vector<RawBorderPiece> border;
  border.reserve(road.size() + 2);
  for (std::size_t i = 0; i < road.size(); ++i) {
    if (i > 0) {
      const Point in = road[i - 1].direction(road[i - 1].length);
      const Point apart = leftwards(in) - leftwards(road[i].forward);
      if (norm(apart) * std::abs(offset) > same_place) {
        border.push_back(join_at(road[i - 1], road[i], offset));
        border.back().of = i;
      }
    }
    RawBorderPiece next{beside(road[i], offset), i, false};
    next.turned_over = next.piece.curved() && dot(next.piece.forward, road[i].forward) < 0;
    // An arc as tight as the offset is a point.
    if (next.piece.length > rounding) border.push_back(next);
  }
  return border;
}

// The place where the straight pieces before and after a bend would meet.
struct RoadCorner {
  Point place;
  Point aside;         // horizontal: to where they would meet at an offset of one metre
  double shorter = 0;  // by how much tangents there are shorter
  double tangent = 0;  // from the place to the arc
};

RoadCorner corner_at(const Point& place, const Point& in, const Point& out, double tangent) {
  const double cosine = dot(unit(in), unit(out)), sine = cross(unit(in), unit(out));
  if (cosine < -1 + 1e-6)
    throw Error(ErrorKind::unsupported, "the road turns back at " + text_of(place.x) + " " +
                                            text_of(place.y) +
                                            ": in space it has no road beside it there");
  const Point aside = (leftwards(in) + leftwards(out)) * (1 / (1 + cosine));
  return {place, aside, sine / (1 + cosine), tangent};
}

std::vector<RoadCorner> corners_of(const std::vector<RoadPiece>& road) {
  std::vector<RoadCorner> corners;
  for (std::size_t i = 0; i < road.size(); ++i) {
    const Point in = road[i].forward, out = road[i].direction(road[i].length);
    if (i > 0) {
      const Point last = road[i - 1].direction(road[i - 1].length);
      if (space::norm(last - in) > same_place)
        corners.push_back(corner_at(road[i].origin, last, in, 0));
    }
    if (!road[i].curved()) continue;
    if (road[i].angle() > 3)
      throw Error(ErrorKind::unsupported, "piece " + std::to_string(i + 1) + " turns by " +
                                              text_of(road[i].angle()) +
                                              " radians in space, expected 3 at most");
    const double tangent = road[i].radius * std::tan(road[i].angle() / 2);
    corners.push_back(corner_at(road[i].origin + in * tangent, in, out, tangent));
  }
  return corners;
}

}  // namespace

std::optional<ArcRoad> flat_offset(const RoadBody& road, double axis_offset) {
  const std::vector<RawBorderPiece> border = raw_border(road.pieces, axis_offset);
  const std::vector<BorderPart> parts = without_bend_loops(border, road.pieces, axis_offset);
  RoadBuilder built(rounding);
  for (const BorderPart& part : parts) built.add(border[part.index].piece.part(part.from, part.to));
  if (built.empty()) return {};
  return built.built(border[parts.back().index].piece.point(parts.back().to));
}

ArcRoad offset_in_space(const RoadBody& road, double axis_offset) {
  const std::vector<RoadPiece>& pieces = road.pieces;
  const std::vector<RoadCorner> corners = corners_of(pieces);
  const Point last = pieces.back().direction(pieces.back().length);
  Line line{pieces.front().origin + leftwards(pieces.front().forward) * axis_offset};
  for (const RoadCorner& corner : corners)
    line.push_back(corner.place + corner.aside * axis_offset);
  line.push_back(road.end + leftwards(last) * axis_offset);
  std::vector<double> lengths;
  std::vector<Bend> bends;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    lengths.push_back(space::distance(line[i], line[i + 1]));
    if (i == 0) continue;
    const Point in = space::unit(line[i] - line[i - 1]), out = space::unit(line[i + 1] - line[i]);
    const RoadCorner& corner = corners[i - 1];
    const double tangent = corner.tangent - axis_offset * corner.shorter;
    if (corner.tangent > 0 && tangent <= 0)
      throw Error(ErrorKind::unsupported,
                  "axis_offset is " + text_of(axis_offset) + ", more than the radius of the bend " +
                      "at " + text_of(corner.place.x) + " " + text_of(corner.place.y));
    const double half = space::norm(out - in) / space::norm(out + in);
    bends.push_back({half, half > 0 ? std::max(tangent, 0.0) / half : 0, {}});
  }
  ArcRoadFit fit;
  fit.radii.push_back({});
  for (const double radius : fit_radii(lengths, bends)) fit.radii.push_back(radius);
  fit.radii.push_back({});
  return ArcRoad::fit(line, fit);
}

}  // namespace streetgen
