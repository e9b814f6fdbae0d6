// A path from lane to lane as few lines and arcs, which set out and arrive as the lanes lead.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "geometry/polyline.hpp"
#include "road/heading.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/plan_view.hpp"

namespace streetgen {

namespace {

using Pieces = std::vector<PlanPiece>;

// Radians, and a share of the length: what is straighter is straight.
constexpr double as_good_as_straight = 1e-9;
// Radians. An arc that turns farther is none that one drives.
constexpr double farthest_turn = 0.95 * M_PI;
// Metres. What is shorter than the one is no piece; between them its heading is lost in digits.
constexpr double nothing = 1e-7, shortest = 1e-2;
// Of a piece, between its ends, where its distance to the path is looked at.
constexpr int looks = 12;

// Adds the arc that sets out from a point in a direction and ends at another; a line where these
// are in one. False where it would turn too far, or is too short.
bool add_arc(const Point& from, const Point& way, const Point& to, Pieces& pieces) {
  const Point chord = to - from;
  const double distance = norm(chord);
  if (distance < nothing) return true;
  if (distance < shortest) return false;
  const double turn = turn_from(way, chord);
  if (2 * std::abs(turn) > farthest_turn) return false;
  PlanPiece piece;
  piece.start = {from, heading_of(way)};
  const bool straight = std::abs(turn) < as_good_as_straight;
  piece.curvature = piece.curvature_end = straight ? 0 : 2 * std::sin(turn) / distance;
  piece.length = straight ? distance : distance * turn / std::sin(turn);
  pieces.push_back(piece);
  return true;
}

struct Ends {
  Point from, way_from, to, way_to;  // unit ways
};

// Two arcs, whose tangents are as long at both ends. None where one would turn too far.
std::optional<Pieces> biarc(const Ends& ends) {
  const Point chord = ends.to - ends.from, ways = ends.way_from + ends.way_to;
  const double ahead = dot(chord, ways), square = dot(chord, chord);
  const double bend = 2 * (1 - dot(ends.way_from, ends.way_to));
  // bend d^2 + 2 ahead d = square, the positive root; written so that no bend divides by nothing.
  const double root = std::sqrt(ahead * ahead + bend * square);
  if (ahead + root <= 1e-12) return std::nullopt;
  const double tangent = square / (ahead + root);
  const Point first = ends.from + ends.way_from * tangent;
  const Point second = ends.to - ends.way_to * tangent;
  Pieces pieces;
  if (!add_arc(ends.from, ends.way_from, (first + second) * 0.5, pieces)) return std::nullopt;
  if (!add_arc((first + second) * 0.5, unit(second - first), ends.to, pieces)) return std::nullopt;
  return pieces;
}

// A line, an arc and a line: the arc leaves the corner where the path does. None where the ends do
// not lead to one corner.
std::optional<Pieces> fillet(const Ends& ends, const Line& path, double tolerance) {
  const double turn = turn_from(ends.way_from, ends.way_to);
  if (std::abs(turn) < 0.01 || std::abs(turn) > farthest_turn) return std::nullopt;
  const Point chord = ends.to - ends.from;
  const double before = cross(chord, ends.way_to) / std::sin(turn);
  const double behind = cross(ends.way_from, chord) / std::sin(turn);
  if (before <= 0 || behind <= 0) return std::nullopt;
  const Point corner = ends.from + ends.way_from * before;
  double off = distance(corner, path.front());
  for (std::size_t i = 1; i < path.size(); ++i)
    off = std::min(off, distance_to_segment(corner, path[i - 1], path[i]));
  // A path that turns on its corner gets an arc all the same.
  off = std::max(off, tolerance / 2);
  const double half = std::abs(turn) / 2;
  const double tangent =
      std::min({off / (1 / std::cos(half) - 1) * std::tan(half), before, behind});
  if (tangent < shortest) return std::nullopt;
  const Point arc_from = corner - ends.way_from * tangent, arc_to = corner + ends.way_to * tangent;
  Pieces pieces;
  if (!add_arc(ends.from, ends.way_from, arc_from, pieces) ||
      !add_arc(arc_from, ends.way_from, arc_to, pieces) ||
      !add_arc(arc_to, ends.way_to, ends.to, pieces))
    return std::nullopt;
  return pieces;
}

// Whether neither leaves the other by more than the tolerance.
bool follows(Pieces pieces, const Line& path, double tolerance) {
  double s = 0;
  for (PlanPiece& piece : pieces) {
    piece.s = s;
    s += piece.length;
  }
  for (const Point& p : path) {
    const double at = station_of(pieces, p).s;
    if (distance(place_at(pieces, at).point, p) > tolerance) return false;
  }
  for (const PlanPiece& piece : pieces)
    for (int i = 1; i < looks; ++i) {
      const Point place = place_at(pieces, piece.s + piece.length * i / looks).point;
      bool near = false;
      for (std::size_t k = 1; k < path.size() && !near; ++k)
        near = distance_to_segment(place, path[k - 1], path[k]) <= tolerance;
      if (!near) return false;
    }
  return true;
}

// The direction at an inner point of the circle through it and its neighbours.
Point way_at(const Line& path, std::size_t i) {
  const Point before = path[i] - path[i - 1], behind = path[i + 1] - path[i];
  return unit(unit(before) * norm(behind) + unit(behind) * norm(before));
}

std::optional<Pieces> between(const Line& path, std::size_t from, std::size_t to,
                              const std::array<Point, 2>& ways, double tolerance) {
  const Line part(path.begin() + from, path.begin() + to + 1);
  const Ends ends{part.front(), from == 0 ? ways[0] : way_at(path, from), part.back(),
                  to + 1 == path.size() ? ways[1] : way_at(path, to)};
  for (const auto& pieces : {biarc(ends), fillet(ends, part, tolerance)})
    if (pieces && follows(*pieces, part, tolerance)) return pieces;
  return std::nullopt;
}

// As few pieces as lead as far as they can, one after the other. None where nothing follows the
// path from one of its points to the next.
std::optional<Pieces> few_pieces(const Line& path, const std::array<Point, 2>& ways,
                                 double tolerance) {
  Pieces pieces;
  for (std::size_t from = 0; from + 1 < path.size();) {
    poll_cancel();
    std::size_t to = path.size() - 1;
    auto next = between(path, from, to, ways, tolerance);
    // What reaches a point mostly reaches those before it.
    if (!next) {
      std::size_t reached = from, beyond = to;
      while (beyond - reached > 1) {
        const std::size_t middle = (reached + beyond) / 2;
        if (auto pieces_to = between(path, from, middle, ways, tolerance)) {
          next = std::move(pieces_to);
          reached = middle;
        } else {
          beyond = middle;
        }
      }
      if (!next) return std::nullopt;
      to = reached;
    }
    pieces.insert(pieces.end(), next->begin(), next->end());
    from = to;
  }
  return pieces;
}

}  // namespace

std::vector<PlanPiece> path_view(const Line& path, const ChainPlace& from, const ChainPlace& to,
                                 double tolerance) {
  Line line{planar(from.point)};
  const Line beside = path_beside(path, from, to);
  for (std::size_t i = 1; i + 1 < beside.size(); ++i)
    if (distance(beside[i], from.point) > tolerance && distance(beside[i], to.point) > tolerance)
      line.push_back(planar(beside[i]));
  line.push_back(planar(to.point));
  line = distinct(line);
  if (line.size() < 2) return {};
  const std::array<Point, 2> ways{along(from.heading), along(to.heading)};
  for (const double wider : {1.0, 2.0, 4.0}) {
    auto pieces = few_pieces(line, ways, wider * tolerance);
    if (!pieces) continue;
    double s = 0;
    for (PlanPiece& piece : *pieces) {
      piece.s = s;
      s += piece.length;
    }
    return *pieces;
  }
  return plan_view(line, tolerance, {from.heading, to.heading});
}

}  // namespace streetgen
