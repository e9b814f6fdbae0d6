#include "layout/round_rings.hpp"

#include <cmath>
#include <optional>
#include <unordered_map>

#include "geometry/fit_circle.hpp"
#include "geometry/polyline.hpp"
#include "layout/smooth_edges.hpp"

namespace streetgen {

namespace {

constexpr std::size_t least_points = 4;    // a circle goes through any three
constexpr double greatest_radius = 150;    // metres
constexpr double chord_off = 0.02;         // metres from the middle of a chord to its arc
constexpr double least_sweep = M_PI / 24;  // an edge about less of the circle stays as it is
constexpr double flattest = 0.5;           // cosine between a segment and the curve at its ends
constexpr double same_vertex = 0.01;       // metres along an axis
constexpr double least_segment = 0.1;      // metres

std::optional<Circle> circle_of(const StreetAxis& axis, double shift) {
  const Line points = distinct(planar(axis.line));
  if (points.size() < least_points) return std::nullopt;
  const std::optional<Circle> circle = fit_circle(points.data(), points.size());
  if (!circle || circle->radius > greatest_radius) return std::nullopt;
  for (const Point& p : points)
    if (std::abs(distance(p, circle->centre) - circle->radius) > shift) return std::nullopt;
  return circle;
}

// None where the line turns back about the middle, or an arc leaves it by more than `shift`.
std::optional<Line> arc_along(const Line& line, const Point& middle, double shift) {
  std::vector<double> sweeps{0};
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point before = line[i - 1] - middle, after = line[i] - middle;
    const double turn = std::atan2(cross(before, after), dot(before, after));
    if (turn == 0 || turn * sweeps.back() < 0) return std::nullopt;
    sweeps.push_back(sweeps.back() + turn);
  }
  const double all = sweeps.back();
  if (std::abs(all) < least_sweep) return std::nullopt;
  const double from = distance(line.front(), middle), to = distance(line.back(), middle);
  const auto radius_at = [&](double share) { return from + (to - from) * share; };
  for (std::size_t i = 1; i + 1 < line.size(); ++i)
    if (std::abs(distance(line[i], middle) - radius_at(sweeps[i] / all)) > shift)
      return std::nullopt;
  const double chord = 2 * std::acos(1 - chord_off / std::max(from, to));
  const int count = static_cast<int>(std::ceil(std::abs(all) / chord));
  const Point start = line.front() - middle;
  const double angle = std::atan2(start.y, start.x);
  Line arc{line.front()};
  for (int i = 1; i < count; ++i) {
    const double share = static_cast<double>(i) / count, at = angle + all * share;
    arc.push_back(middle + Point{std::cos(at), std::sin(at), 0} * radius_at(share));
  }
  arc.push_back(line.back());
  return arc;
}

// The vertices of an axis before and behind an edge; of one that is closed, round its end.
struct Neighbours {
  std::optional<Point> before, behind;
};

Neighbours neighbours_of(const Edge& edge, const StreetAxis& axis) {
  const Line line = distinct(planar(axis.line));
  Neighbours found;
  double abscissa = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i > 0) abscissa += distance(line[i - 1], line[i]);
    if (abscissa < edge.start_abscissa - same_vertex) found.before = line[i];
    if (!found.behind && abscissa > edge.end_abscissa + same_vertex) found.behind = line[i];
  }
  if (same(line.front(), line.back())) {
    if (!found.before) found.before = line[line.size() - 2];
    if (!found.behind) found.behind = line[1];
  }
  return found;
}

// Of the circle through three points, at the middle one.
Point direction_at(const Point& before, const Point& at, const Point& behind) {
  const Point in = at - before, out = behind - at;
  return unit(in * (1 / dot(in, in)) + out * (1 / dot(out, out)));
}

// The direction at the other end of an arc over a chord.
Point mirrored(const Point& direction, const Point& chord) {
  return chord * (2 * dot(direction, chord)) - direction;
}

// A cubic curve for each segment, near to an arc, with a common direction at each point.  None
// where it leaves a segment by more than `shift`, or two points are all.
std::optional<Line> curve_through(const Line& line, Neighbours beside, double shift) {
  const std::size_t last = line.size() - 1;
  // A node may have been snapped to the vertex beyond it.
  if (beside.before && distance(*beside.before, line.front()) < least_segment) beside.before.reset();
  if (beside.behind && distance(*beside.behind, line.back()) < least_segment) beside.behind.reset();
  std::vector<Point> directions(line.size());
  const auto chord = [&](std::size_t i) { return unit(line[i + 1] - line[i]); };
  for (std::size_t i = 1; i < last; ++i)
    directions[i] = direction_at(line[i - 1], line[i], line[i + 1]);
  if (last == 1 && !beside.before && !beside.behind) return std::nullopt;
  if (beside.before) directions[0] = direction_at(*beside.before, line[0], line[1]);
  if (beside.behind) directions[last] = direction_at(line[last - 1], line[last], *beside.behind);
  if (!beside.before) directions[0] = mirrored(directions[1], chord(0));
  if (!beside.behind) directions[last] = mirrored(directions[last - 1], chord(last - 1));
  Line curve{line.front()};
  for (std::size_t i = 0; i < last; ++i) {
    const Point &a = line[i], &b = line[i + 1], along = chord(i);
    const double size = distance(a, b);
    const double leaves = dot(along, directions[i]), comes = dot(along, directions[i + 1]);
    const double least = std::min(leaves, comes);
    if (least < flattest) return std::nullopt;
    const double off = size * std::sqrt(1 - std::min(1.0, least * least)) / (1 + least) / 2;
    if (off > shift) return std::nullopt;
    const Point from = a + directions[i] * (size * 2 / 3 / (1 + leaves));
    const Point to = b - directions[i + 1] * (size * 2 / 3 / (1 + comes));
    const int count = std::max(1, static_cast<int>(std::ceil(std::sqrt(off / chord_off))));
    for (int k = 1; k < count; ++k) {
      const double t = static_cast<double>(k) / count, rest = 1 - t;
      curve.push_back(a * (rest * rest * rest) + from * (3 * rest * rest * t) +
                      to * (3 * rest * t * t) + b * (t * t * t));
    }
    curve.push_back(b);
  }
  return curve;
}

}  // namespace

void round_rings(Network& network, const std::vector<StreetAxis>& axes, double shift) {
  if (shift <= 0) return;
  struct Ring {
    const StreetAxis* axis;
    std::optional<Circle> circle;
  };
  std::unordered_map<std::int64_t, Ring> rings;
  for (const StreetAxis& axis : axes)
    if (axis.on_ring) rings.emplace(axis.axis_id, Ring{&axis, circle_of(axis, shift)});
  if (rings.empty()) return;
  for (Edge& edge : network.edges) {
    const auto found = rings.find(edge.axis_id);
    if (found == rings.end()) continue;
    const auto& [axis, circle] = found->second;
    const Line line = distinct(planar(edge.line));
    std::optional<Line> round;
    if (circle) round = arc_along(line, circle->centre, shift);
    if (!round) round = curve_through(line, neighbours_of(edge, *axis), shift);
    if (round) edge.line = with_heights(std::move(*round), edge.line);
  }
}

}  // namespace streetgen
