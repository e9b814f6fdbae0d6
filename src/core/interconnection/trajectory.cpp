#include "streetgen/trajectory.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"
#include "support/infinite.hpp"

namespace streetgen {

namespace {

constexpr int most_chords = 1000;
constexpr double no_angle = 1e-9;        // sine of an angle that is none
constexpr double shortest_piece = 1e-6;  // metres: a shorter one has no direction to speak of

int chords(double wanted) {
  return static_cast<int>(std::clamp(std::ceil(wanted - 1e-9), 1.0, 1.0 * most_chords));
}

// From a start in one direction to an end in another.
struct Passage {
  Point start, start_direction, end, end_direction;

  // The distances ahead of the start and behind the end at which their tangents meet; 0 where
  // parallel.
  struct Reach {
    double ahead = 0, behind = 0;
  };
  Reach reach() const {
    const double sine = cross(start_direction, end_direction);
    if (std::abs(sine) < no_angle) return {};
    const Point chord = end - start;
    return {cross(chord, end_direction) / sine, cross(start_direction, chord) / sine};
  }

  // The crossing of the tangents, where it lies ahead of the start and behind the end, and the way
  // does not turn back.
  std::optional<Point> crossing_ahead() const {
    const auto [ahead, behind] = reach();
    const double cosine = dot(start_direction, end_direction);
    if (!(ahead > 0 && behind > 0) || cosine <= -parallel_cosine) return std::nullopt;
    return start + start_direction * ahead;
  }
};

// The first place of a walk along a line that is not that where it starts, or its end.
template <class Walk>
Point next_place(Walk start, Walk end) {
  Walk next = start + 1;
  while (next + 1 != end && !(distance(*next, *start) > 0)) ++next;
  return *next;
}

Passage passage(const Line& lane_in, const Line& lane_out) {
  const Point start = planar(lane_in.back()), end = planar(lane_out.front());
  return {start, unit(start - next_place(lane_in.rbegin(), lane_in.rend())), end,
          unit(next_place(lane_out.begin(), lane_out.end()) - end)};
}

Point middle(const Point& a, const Point& b) { return (a + b) * 0.5; }

Point paper_control(const Passage& way, const Point& centre) {
  const double cosine = dot(way.start_direction, way.end_direction);
  const Point between = middle(way.start, way.end);
  if (cosine >= parallel_cosine) return between;
  if (cosine <= -parallel_cosine) return middle(between, planar(centre));
  return middle(way.start + way.start_direction * way.reach().ahead, planar(centre));
}

// A chord of 1 / n of the curve leaves it by |start - 2 control + end| / 4 n^2.
Line bezier(const Point& start, const Point& control, const Point& end, double tolerance) {
  const int n = chords(std::sqrt(norm(start - control * 2 + end) / (4 * tolerance)));
  Line line;
  line.reserve(n + 1);
  line.push_back(start);
  for (int i = 1; i < n; ++i) {
    const double t = static_cast<double>(i) / n;
    line.push_back(start * ((1 - t) * (1 - t)) + control * (2 * t * (1 - t)) + end * (t * t));
  }
  line.push_back(end);
  return line;
}

// Goes on from the line's end, where it has `direction`, along an arc; returns the direction there.
Point append_tangent_arc(Line& line, const Point& direction, const Point& to, double tolerance) {
  const Point from = line.back(), chord = unit(to - from);
  if (norm(chord) == 0) return direction;
  const double sine = cross(direction, chord), half_sweep = std::atan2(sine, dot(direction, chord));
  if (std::abs(sine) >= no_angle) {
    const double diameter = distance(from, to) / std::abs(sine);
    const double step = 2 * std::acos(std::max(1 - 2 * tolerance / diameter, 0.5));
    const int n = chords(2 * std::abs(half_sweep) / step);
    for (int i = 1; i < n; ++i) {
      const double turn = half_sweep * i / n;
      const Point ray = direction * std::cos(turn) + left_normal(direction) * std::sin(turn);
      line.push_back(from + ray * (diameter * std::sin(std::abs(turn))));
    }
  }
  line.push_back(to);
  return chord * (2 * dot(direction, chord)) - direction;
}

Trajectory tangent_arcs(const Passage& way, double tolerance) {
  Trajectory path{middle(way.start, way.end), {way.start}};
  const auto [ahead, behind] = way.reach();
  const double cosine = dot(way.start_direction, way.end_direction);
  if (ahead > 0 && behind > 0 && cosine > -parallel_cosine) {
    path.control = way.start + way.start_direction * ahead;
    const double tangent = std::min(ahead, behind);
    if (ahead > behind + shortest_piece)
      path.line.push_back(path.control - way.start_direction * tangent);
    append_tangent_arc(path.line, way.start_direction, path.control + way.end_direction * tangent,
                       tolerance);
    if (behind > ahead + shortest_piece) path.line.push_back(way.end);
  } else {
    // Two arcs whose tangents at the ends are equally long.
    const Point chord = way.end - way.start, sum = way.start_direction + way.end_direction;
    const double along = dot(chord, sum), square = dot(chord, chord);
    const double root = std::sqrt(along * along + 2 * (1 - cosine) * square);
    const double tangent = along + root > no_angle * root ? square / (along + root) : 0;
    const Point joint =
        middle(way.start + way.start_direction * tangent, way.end - way.end_direction * tangent);
    path.control = joint;
    const Point direction = append_tangent_arc(path.line, way.start_direction, joint, tolerance);
    append_tangent_arc(path.line, direction, way.end, tolerance);
  }
  if (path.line.size() < 2) path.line.push_back(way.end);
  path.line.back() = way.end;
  return path;
}

// The control point slides towards the crossing of the lanes until the path is wide enough; where
// no such path is, arcs may be wider.
template <class ByControl>
Trajectory widened(const Passage& way, const Trajectory& path, double least_radius,
                   double tolerance, ByControl by_control) {
  const auto [ahead, behind] = way.reach();
  const double cosine = dot(way.start_direction, way.end_direction);
  if (!(ahead > 0 && behind > 0) || std::abs(cosine) >= parallel_cosine) return path;
  const Point crossing = way.start + way.start_direction * ahead;
  Trajectory widest = path;
  double radius = quarter_radius(path.line);
  for (int step = 1; step <= 8 && radius < least_radius; ++step) {
    Trajectory next = by_control(path.control + (crossing - path.control) * (step / 8.0));
    const double wider = quarter_radius(next.line);
    if (wider <= radius) continue;
    radius = wider;
    widest = std::move(next);
  }
  if (radius >= least_radius) return widest;
  Trajectory arcs = tangent_arcs(way, tolerance);
  return quarter_radius(arcs.line) > radius ? arcs : widest;
}

double circumradius(const Point& a, const Point& b, const Point& c) {
  const double twice_area = std::abs(cross(b - a, c - a));
  const double sides = distance(a, b) * distance(b, c) * distance(c, a);
  return twice_area > 0 ? sides / (2 * twice_area) : infinite;
}

}  // namespace

Trajectory trajectory(const Line& lane_in, const Line& lane_out, const Point& centre,
                      TrajectoryRule rule, double tolerance, double least_radius,
                      const std::optional<Point>& control) {
  const Passage way = passage(lane_in, lane_out);
  const auto by_control = [&](const Point& point) {
    return Trajectory{point, bezier(way.start, point, way.end, tolerance)};
  };
  if (control) return by_control(planar(*control));
  if (rule == TrajectoryRule::arcs) return tangent_arcs(way, tolerance);
  const Trajectory path = by_control(paper_control(way, centre));
  return least_radius > 0 ? widened(way, path, least_radius, tolerance, by_control) : path;
}

Trajectory tangent_trajectory(const Line& lane_in, const Line& lane_out, TrajectoryRule rule,
                              double tolerance) {
  const Passage way = passage(lane_in, lane_out);
  const std::optional<Point> crossing = way.crossing_ahead();
  if (!crossing || rule == TrajectoryRule::arcs) return tangent_arcs(way, tolerance);
  return {*crossing, bezier(way.start, *crossing, way.end, tolerance)};
}

double sharpest_turn(const Line& path) {
  double sharpest = 0;
  Point before;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Point along = path[i] - path[i - 1];
    if (!(norm(along) > 0)) continue;
    if (norm(before) > 0)
      sharpest = std::max(sharpest, std::atan2(std::abs(cross(before, along)), dot(before, along)));
    before = along;
  }
  return sharpest * 180 / M_PI;
}

double quarter_radius(const Line& path) {
  const double quarter = length(path) / 4;
  if (!(quarter > 0)) return infinite;
  Point points[5];
  std::size_t segment = 0;
  double before = 0, size = distance(path[0], path[1]);
  for (int i = 0; i < 5; ++i) {
    while (segment + 2 < path.size() && i * quarter >= before + size) {
      before += size;
      ++segment;
      size = distance(path[segment], path[segment + 1]);
    }
    const double t = size > 0 ? std::clamp((i * quarter - before) / size, 0.0, 1.0) : 0;
    points[i] =
        t == 1 ? path[segment + 1] : path[segment] + (path[segment + 1] - path[segment]) * t;
  }
  double least = infinite;
  for (int i = 0; i < 3; ++i)
    least = std::min(least, circumradius(points[i], points[i + 1], points[i + 2]));
  return least;
}

}  // namespace streetgen
