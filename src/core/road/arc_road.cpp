#include "streetgen/arc_road.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/space.hpp"
#include "geometry/tolerance.hpp"
#include "road/road_body.hpp"
#include "road/road_vertex.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"

namespace streetgen {

namespace {

constexpr double gravity = 9.81;  // m/s2

bool one_height(const std::vector<RoadPiece>& pieces, const Point& end) {
  return std::all_of(pieces.begin(), pieces.end(), [&](const RoadPiece& piece) {
    return piece.origin.z == end.z && piece.forward.z == 0 && piece.inward.z == 0;
  });
}

void refuse_gap(const Point& from, const Point& to, double least, std::size_t number) {
  if (space::distance(from, to) > std::max(same_place, least))
    throw Error(ErrorKind::invalid_input, "piece " + std::to_string(number) + " begins " +
                                              text_of(space::distance(from, to)) +
                                              " m from the end of the one before it");
}

// The middle of an arc between ends as they are stored: only its own rounding moves it.
Point middle_of(const RoadPiece& piece, const Point& end) {
  const double half = std::sin(piece.angle() / 4);
  const Point outward = piece.towards_centre(piece.length / 2) * -1;
  const Point chord = end - piece.origin;
  return piece.origin + (chord * 0.5 + outward * (2 * piece.radius * half * half));
}

}  // namespace

RoadBuilder::RoadBuilder(double least) : body_(std::make_shared<RoadBody>()), least_(least) {}

double RoadBuilder::add(RoadPiece piece) {
  const double start = body_->length;
  if (piece.length <= least_) return start;
  piece.start = start;
  body_->length += piece.length;
  body_->pieces.push_back(piece);
  return start;
}

ArcRoad RoadBuilder::built(const Point& end, std::vector<RoadArc> arcs) {
  poll_cancel();
  body_->starts.reserve(body_->pieces.size());
  for (const RoadPiece& piece : body_->pieces) body_->starts.push_back(piece.start);
  body_->index = PieceIndex(body_->pieces);
  body_->end = end;
  body_->arcs = std::move(arcs);
  body_->flat = one_height(body_->pieces, end);
  return ArcRoad(std::move(body_));
}

Point leftwards(const Point& direction) { return left_normal(unit(direction)); }

double chord_angle(double radius, double tolerance) {
  // 2 acos(1 - tolerance / radius), of which the cosine would lose the digits.
  return 4 * std::asin(std::sqrt(std::min(tolerance / (2 * radius), 0.5)));
}

std::size_t chord_count(double angle, double radius, double tolerance) {
  return std::max<std::size_t>(1, std::ceil(angle / chord_angle(radius, tolerance) - 1e-9));
}

ArcRoad ArcRoad::along(const CurvedLine& curve) {
  Line ends;
  for (const RingPiece& piece : curve) ends.insert(ends.end(), {piece.arc.start, piece.arc.end});
  const double least = resolution(ends);
  RoadBuilder road(least);
  for (std::size_t i = 0; i < curve.size(); ++i) {
    poll_cancel();
    const Arc& arc = curve[i].arc;
    if (i > 0) refuse_gap(curve[i - 1].arc.end, arc.start, least, i + 1);
    const RoadPiece piece = curve[i].curved ? arc_piece(arc) : straight_piece(arc.start, arc.end);
    if (piece.length <= least) continue;
    for (const double at : {0.0, piece.length})
      refuse_vertical({}, piece.direction(at), "point", i + 1);
    road.add(piece);
  }
  if (road.empty())
    throw Error(ErrorKind::invalid_input, "the road has no length: all its points are one");
  return road.built(curve.back().arc.end);
}

double ArcRoad::length() const { return body_->length; }

bool ArcRoad::flat() const { return body_->flat; }

const std::vector<RoadArc>& ArcRoad::arcs() const { return body_->arcs; }

CurvedLine ArcRoad::curve() const {
  CurvedLine curve;
  curve.reserve(body_->pieces.size());
  for (std::size_t i = 0; i < body_->pieces.size(); ++i) {
    const RoadPiece& piece = body_->pieces[i];
    const Point end = i + 1 < body_->pieces.size() ? body_->pieces[i + 1].origin : body_->end;
    const Point middle = piece.curved() ? middle_of(piece, end) : Point{};
    curve.push_back({{piece.origin, middle, end}, piece.curved()});
  }
  return curve;
}

std::vector<ArcRoad::Stretch> ArcRoad::stretches() const {
  std::vector<Stretch> found;
  found.reserve(body_->pieces.size());
  for (const RoadPiece& piece : body_->pieces)
    found.push_back({piece.start, piece.start + piece.length,
                     turn_of(piece) < 0 ? -piece.radius : piece.radius});
  return found;
}

std::vector<ArcRoad::Bend> ArcRoad::bends() const {
  const CurvedLine pieces = curve();
  const std::vector<Stretch> along = stretches();
  std::vector<Bend> found;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!pieces[i].curved) continue;
    const RoadPiece& piece = body_->pieces[i];
    const double half = piece.length / piece.radius / 2;
    const Point corner = piece.origin + piece.forward * (piece.radius * std::tan(half));
    found.push_back({along[i], piece.centre(), corner, pieces[i].arc});
  }
  return found;
}

std::vector<ArcRoad::Kink> ArcRoad::kinks() const {
  constexpr double least_jump = 1e-3, rounding = 1e-8;  // radians, metres
  std::vector<Kink> found;
  for (std::size_t i = 0; i + 1 < body_->pieces.size(); ++i) {
    const RoadPiece &before = body_->pieces[i], &after = body_->pieces[i + 1];
    if (!before.curved() && !after.curved()) continue;
    const Point in = before.direction(before.length), out = after.forward;
    const double jump = std::atan2(space::norm(space::cross(in, out)), space::dot(in, out));
    if (jump > std::max(least_jump, rounding / std::min(before.length, after.length)))
      found.push_back({after.origin, jump});
  }
  return found;
}

RoadPlace ArcRoad::at(double abscissa) const {
  const std::vector<double>& starts = body_->starts;
  const auto next = std::upper_bound(starts.begin() + 1, starts.end(), abscissa);
  const RoadPiece& piece = body_->pieces[next - starts.begin() - 1];
  const double at = std::clamp(abscissa - piece.start, 0.0, piece.length);
  RoadPlace place;
  place.point = piece.point(at);
  place.forward = piece.direction(at);
  const Point left = leftwards(place.forward);
  place.right = left * -1;
  place.up = space::cross(place.right, place.forward);
  place.heading = std::atan2(place.forward.y, place.forward.x);
  if (piece.curved()) place.curvature = dot(piece.towards_centre(at), left) / piece.radius;
  return place;
}

RoadFoot ArcRoad::locate(const Point& point) const {
  Point from = point;
  if (body_->flat) from.z = body_->end.z;
  const auto [index, at] = body_->index.nearest(body_->pieces, from);
  const RoadPiece& piece = body_->pieces[index];
  const Point away = from - piece.point(at);
  return {piece.start + at, dot(away, leftwards(piece.direction(at))), space::norm(away)};
}

std::optional<ArcRoad> ArcRoad::offset(double axis_offset) const {
  if (std::abs(axis_offset) <= rounding) return *this;
  if (!body_->flat) return offset_in_space(*body_, axis_offset);
  return flat_offset(*body_, axis_offset);
}

Line ArcRoad::line(double tolerance) const {
  Line line;
  for (const RoadPiece& piece : body_->pieces) {
    poll_cancel();
    line.push_back(piece.origin);
    if (!piece.curved()) continue;
    const std::size_t count = chord_count(piece.angle(), piece.radius, tolerance);
    for (std::size_t i = 1; i < count; ++i) line.push_back(piece.point(piece.length * i / count));
  }
  line.push_back(body_->end);
  return line;
}

std::vector<Triangle> ArcRoad::mesh(double offset_left, double offset_right,
                                    double tolerance) const {
  if (!(offset_left > offset_right))
    throw Error(ErrorKind::invalid_input, "offset_left is " + text_of(offset_left) +
                                              ", expected more than offset_right, which is " +
                                              text_of(offset_right));
  return road_mesh(*body_, offset_left, offset_right, tolerance);
}

double arc_speed_limit(double radius, double friction, double superelevation, double safety) {
  const double grip = (friction + superelevation) / (1 - friction * superelevation);
  return 3.6 * safety * std::sqrt(gravity * radius * std::max(grip, 0.0));
}

}  // namespace streetgen
