#include "ownership/notch.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/box.hpp"
#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"

namespace streetgen {

namespace {

constexpr double widest_wedge = 135 * M_PI / 180 + same_angle;
constexpr double farthest = 1.5;      // metres from the place where the borders cross
constexpr double beside = 0.01;       // metres: ground this near to that place is in the wedge
constexpr double least_radius = 0.1;  // metres: kerbs that cross at a sharper angle leave a slit
constexpr int chords = 8;
constexpr double least_sine = 1e-6;
const double smooth_cosine = std::cos(M_PI / 4 + same_angle);

// A side of a ring, which has the surface on its left.
struct RingSide {
  const Ring* ring;
  std::size_t end;  // index of the point where it ends

  const Point& from() const { return (*ring)[end - 1]; }
  const Point& to() const { return (*ring)[end]; }
  Box box() const { return box_of(from(), to()); }
};

std::vector<RingSide> sides_in(const MultiPolygon& surface, const Box& box) {
  std::vector<RingSide> sides;
  for (const Polygon& polygon : surface)
    for (const Ring& ring : polygon)
      for (std::size_t i = 1; i < ring.size(); ++i)
        if (box_of(ring[i - 1], ring[i]).meets(box)) sides.push_back({&ring, i});
  return sides;
}

// From a place on a border along it, as far as it bends by less than 45 degrees, so that no end of
// a border line is passed.
Line smooth_part(const RingSide& side, const Point& start, bool forwards) {
  const Ring& ring = *side.ring;
  const std::size_t count = ring.size() - 1;  // the last point is the first
  std::size_t next = forwards ? side.end % count : side.end - 1;
  Line line{start};
  double size = 0;
  Point along;
  for (std::size_t step = 0; step < count && size < farthest; ++step) {
    const Point way = ring[next] - line.back();
    if (norm(way) > 0) {
      if (norm(along) > 0 && dot(along, unit(way)) < smooth_cosine) break;
      along = unit(way);
      size += norm(way);
      line.push_back(ring[next]);
    }
    next = forwards ? (next + 1) % count : (next + count - 1) % count;
  }
  return line;
}

// Whether one goes through the other; a touch does not count.
bool cross_each_other(const RingSide& a, const RingSide& b) {
  const Point along_a = a.to() - a.from(), along_b = b.to() - b.from();
  return cross(along_a, b.from() - a.from()) * cross(along_a, b.to() - a.from()) < 0 &&
         cross(along_b, a.from() - b.from()) * cross(along_b, a.to() - b.from()) < 0;
}

// An arc that leaves `from` towards the corner. Nothing where `to` lies behind: a border that bends
// back beside the corner has no notch there, and the arc would run round a whole city.
std::optional<Line> bend(const Point& from, const Point& corner, const Point& to) {
  const Point along = unit(corner - from), chord = unit(to - from);
  if (dot(along, chord) <= 0) return std::nullopt;
  const double sine = cross(along, chord), half_sweep = std::atan2(sine, dot(along, chord));
  const double diameter = distance(from, to) / std::max(std::abs(sine), least_sine);
  Line line{from};
  for (int i = 1; i < chords; ++i) {
    const double turn = half_sweep * i / chords;
    const Point ray = along * std::cos(turn) + left_normal(along) * std::sin(turn);
    line.push_back(from + ray * (diameter * std::sin(std::abs(turn))));
  }
  line.push_back(to);
  return line;
}

std::optional<Line> across(const RingSide& a, const RingSide& b, const Point& place, double radius,
                           const std::function<bool(const Point&)>& is_free) {
  // The border of a is free where it lies on the right of b.
  const bool a_onwards = cross(b.to() - b.from(), a.to() - a.from()) < 0;
  const Point along_a = unit(a.to() - a.from()) * (a_onwards ? 1 : -1);
  const Point along_b = unit(b.to() - b.from()) * (a_onwards ? -1 : 1);
  const Point middle = along_a + along_b;
  if (norm(middle) == 0 || !is_free(place + unit(middle) * beside)) return std::nullopt;
  const double wedge = std::acos(std::clamp(dot(along_a, along_b), -1.0, 1.0));
  if (wedge > widest_wedge) return std::nullopt;
  const Line on_a = smooth_part(a, place, a_onwards), on_b = smooth_part(b, place, !a_onwards);
  const double away =
      std::min({radius / std::tan(wedge / 2), farthest, length(on_a), length(on_b)});
  if (away * std::tan(wedge / 2) < least_radius) return std::nullopt;
  const LinePosition from = position_at(on_a, away), to = position_at(on_b, away);
  if (!is_free((from.point + to.point) * 0.5)) return std::nullopt;
  std::optional<Line> line = bend(from.point, place, to.point);
  if (!line) return line;
  // The surface lies on the left of a ring.
  const double side = a_onwards ? coordinate_margin : -coordinate_margin;
  line->insert(line->begin(), from.point + left_normal(from.direction) * side);
  line->push_back(to.point - left_normal(to.direction) * side);
  return line;
}

}  // namespace

std::vector<Line> across_notches(const MultiPolygon& a, const MultiPolygon& b, double radius,
                                 const std::function<bool(const Point&)>& is_free) {
  std::vector<Line> lines;
  const Box shared = box_of(a).shared_with(box_of(b));
  const std::vector<RingSide> of_b = sides_in(b, shared);
  if (of_b.empty()) return lines;
  for (const RingSide& side : sides_in(a, shared)) {
    const Box box = side.box();
    for (const RingSide& other : of_b) {
      if (!box.meets(other.box()) || !cross_each_other(side, other)) continue;
      const auto place = crossing(side.from(), side.to(), other.from(), other.to());
      if (!place) continue;
      if (auto line = across(side, other, *place, radius, is_free))
        lines.push_back(std::move(*line));
    }
  }
  return lines;
}

}  // namespace streetgen
