#include "road/road_piece.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/space.hpp"
#include "geometry/tolerance.hpp"

namespace streetgen {

namespace {

constexpr double turn_around = 2 * M_PI;

// Metres from the origin of an arc to the angle at which p stands about its centre, full circle.
double along_circle(const RoadPiece& arc, const Point& p) {
  const Point away = p - arc.centre();
  double angle = std::atan2(space::dot(away, arc.forward), -space::dot(away, arc.inward));
  if (angle < 0) angle += turn_around;
  return angle * arc.radius;
}

// The same, of a place on the arc: rounding leaves neither end.
double on_arc(const RoadPiece& arc, const Point& p) {
  const double at = along_circle(arc, p);
  return at > arc.length && turn_around * arc.radius - at < same_place ? 0 : at;
}

void straight_with_straight(const RoadPiece& a, const RoadPiece& b,
                            std::vector<PieceCrossing>& found) {
  const double sine = cross(a.forward, b.forward);
  if (std::abs(sine) <= straight_sine) return;
  const Point between = b.origin - a.origin;
  found.push_back({cross(between, b.forward) / sine, cross(between, a.forward) / sine});
}

void straight_with_arc(const RoadPiece& a, const RoadPiece& b, std::vector<PieceCrossing>& found) {
  const Point to_centre = b.centre() - a.origin;
  const double foot = dot(to_centre, a.forward), away = cross(a.forward, to_centre);
  const double square = (b.radius - away) * (b.radius + away);
  if (square < 0) return;
  for (const double half : {-std::sqrt(square), std::sqrt(square)})
    found.push_back({foot + half, on_arc(b, a.point(foot + half))});
}

void arc_with_arc(const RoadPiece& a, const RoadPiece& b, std::vector<PieceCrossing>& found) {
  const Point between = b.centre() - a.centre();
  const double d = norm(between);
  if (d < rounding) return;
  const double foot = (d * d + (a.radius - b.radius) * (a.radius + b.radius)) / (2 * d);
  const double square = (a.radius - foot) * (a.radius + foot);
  if (square < 0) return;
  const Point along = between * (1 / d);
  for (const double half : {-std::sqrt(square), std::sqrt(square)}) {
    const Point place = a.centre() + along * foot + left_normal(along) * half;
    found.push_back({on_arc(a, place), on_arc(b, place)});
  }
}

}  // namespace

Point RoadPiece::centre() const { return origin + inward * radius; }

Point RoadPiece::point(double at) const {
  if (!curved()) return origin + forward * at;
  const double angle = at / radius, half = std::sin(angle / 2);
  return origin + (forward * (radius * std::sin(angle)) + inward * (2 * radius * half * half));
}

Point RoadPiece::direction(double at) const {
  if (!curved()) return forward;
  const double angle = at / radius;
  return forward * std::cos(angle) + inward * std::sin(angle);
}

Point RoadPiece::towards_centre(double at) const {
  if (!curved()) return {};
  const double angle = at / radius;
  return inward * std::cos(angle) - forward * std::sin(angle);
}

double RoadPiece::nearest(const Point& p) const {
  if (!curved()) return std::clamp(space::dot(p - origin, forward), 0.0, length);
  const double at = along_circle(*this, p);
  if (at <= length) return at;
  return at - length < turn_around * radius - at ? length : 0;
}

Box RoadPiece::box() const {
  Box box = box_of(origin, end());
  if (!curved()) return box;
  const double whole = angle();
  if (whole < 2) {
    // The arc lies in the triangle of its chord and its tangents, which is found sooner.
    box.add(origin + forward * (radius * std::tan(whole / 2)));
    return box;
  }
  // The arc turns back where its direction has no part along x, or along y.
  for (const double first : {std::atan2(-forward.x, inward.x), std::atan2(-forward.y, inward.y)})
    for (double at = first < 0 ? first + M_PI : first; at < whole; at += M_PI)
      box.add(point(at * radius));
  return box;
}

RoadPiece RoadPiece::part(double from, double to) const {
  RoadPiece piece = *this;
  piece.origin = point(from);
  piece.forward = direction(from);
  piece.inward = towards_centre(from);
  piece.start = start + from;
  piece.length = to - from;
  return piece;
}

RoadPiece straight_piece(const Point& from, const Point& to) {
  RoadPiece piece;
  piece.origin = from;
  piece.forward = space::unit(to - from);
  piece.length = space::distance(from, to);
  return piece;
}

RoadPiece arc_piece(const Arc& arc) {
  const Point half = arc.middle - arc.start, whole = arc.end - arc.start;
  RoadPiece piece;
  piece.origin = arc.start;
  if (space::norm(whole) == 0) {
    piece.inward = space::unit(half);
    piece.forward = {piece.inward.y, -piece.inward.x, 0};
    piece.radius = space::norm(half) / 2;
    piece.length = turn_around * piece.radius;
    return piece;
  }
  const Point rest = arc.end - arc.middle;
  const Point normal = space::cross(half, whole);
  const double sine = space::norm(normal);
  if (sine <= straight_sine * space::norm(half) * space::norm(whole))
    return straight_piece(arc.start, arc.end);
  // An angle over a chord, seen from the circle, is half of the arc that the chord spans.
  const double second = std::atan2(sine, space::dot(half, whole));
  const double first = std::atan2(sine, space::dot(rest, whole));
  const Point axis = normal * (1 / sine), along = space::unit(half);
  const Point aside = space::cross(axis, along);
  piece.forward = along * std::cos(first) - aside * std::sin(first);
  piece.inward = space::cross(axis, piece.forward);
  piece.radius = first + second < M_PI / 2 ? space::norm(whole) / (2 * std::sin(first + second))
                                           : space::norm(half) / (2 * std::sin(first));
  piece.length = 2 * (first + second) * piece.radius;
  return piece;
}

std::vector<PieceCrossing> crossings(const RoadPiece& a, const RoadPiece& b) {
  std::vector<PieceCrossing> found, kept;
  if (!a.curved() && !b.curved()) straight_with_straight(a, b, found);
  if (!a.curved() && b.curved()) straight_with_arc(a, b, found);
  if (a.curved() && b.curved()) arc_with_arc(a, b, found);
  if (a.curved() && !b.curved()) {
    straight_with_arc(b, a, found);
    for (PieceCrossing& crossing : found) std::swap(crossing.a, crossing.b);
  }
  const auto within = [](double at, const RoadPiece& piece) {
    return at >= -rounding && at <= piece.length + rounding;
  };
  for (const PieceCrossing& crossing : found)
    if (within(crossing.a, a) && within(crossing.b, b))
      kept.push_back(
          {std::clamp(crossing.a, 0.0, a.length), std::clamp(crossing.b, 0.0, b.length)});
  return kept;
}

PieceIndex::PieceIndex(const std::vector<RoadPiece>& pieces) {
  std::vector<Box> boxes;
  boxes.reserve(pieces.size() + pieces.size() / 4);
  for (const RoadPiece& piece : pieces) boxes.push_back(piece.box());
  boxes_ = BoxHierarchy(std::move(boxes));
}

std::pair<std::size_t, double> PieceIndex::nearest(const std::vector<RoadPiece>& pieces,
                                                   const Point& p) const {
  const int found = boxes_.nearest(p, [&](int i) {
    const Point away = p - pieces[i].point(pieces[i].nearest(p));
    return space::dot(away, away);
  });
  return {found, pieces[found].nearest(p)};
}

bool PieceIndex::comes_within(const std::vector<RoadPiece>& pieces, const Point& p, double reach,
                              std::size_t first, std::size_t last) const {
  return boxes_.any_near(box_of(p, p), reach, [&](std::size_t i) {
    return i >= first && i <= last &&
           space::distance(p, pieces[i].point(pieces[i].nearest(p))) < reach;
  });
}

}  // namespace streetgen
