#include "layout/node_corner.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "network/leaving_order.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

// Beyond this angle from a to b the corner lies outside a bend and has no arc.
constexpr double widest_corner = 200 * M_PI / 180 + same_angle;
// From here on the borders are nearly one line: an arc that does not fit is left out.
constexpr double nearly_straight = 160 * M_PI / 180 + same_angle;

constexpr double shortest_arc = 5e-3;  // metres

double heading(const Arm& arm, double abscissa) {
  const Point d = position_at(arm.line, abscissa).point - arm.line.front();
  return std::atan2(d.y, d.x);
}

// The arm with a straight piece before its node.
Line led_back(const Arm& arm, double by) {
  Line line = arm.line;
  line.front() = line[0] - unit(line[1] - line[0]) * by;
  return line;
}

// Each as wide as at its node, on the side of the corner.  A kerb beside its axis may meet the
// other one behind the node: the abscissa is negative there.
std::optional<CornerArc> corner_arc(const Arm& a, const Arm& b, double radius) {
  const double width_a = 2 * a.start_to(+1), width_b = 2 * b.start_to(-1);
  const auto found = corner_arc(a.line, b.line, width_a, width_b, radius);
  const bool beside = a.roadway_offset != 0 || b.roadway_offset != 0;
  const bool at_node = found && (found->abscissa_a == 0 || found->abscissa_b == 0);
  if (!beside || !at_node || cross(a.line[1] - a.line[0], b.line[1] - b.line[0]) <= 0) return found;
  const auto behind = corner_behind(a, b, radius);
  return behind ? behind : found;
}
std::optional<double> max_corner_radius(const Arm& a, const Arm& b, double radius_limit) {
  return max_corner_radius(a.line, b.line, 2 * a.start_to(+1), 2 * b.start_to(-1), radius_limit);
}

}  // namespace

std::optional<CornerArc> corner_behind(const Arm& a, const Arm& b, double radius) {
  const double by = 4 * (a.reach() + b.reach() + radius);
  auto behind = corner_arc(led_back(a, by), led_back(b, by), 2 * a.start_to(+1), 2 * b.start_to(-1),
                           radius, planar(a.line.front()));
  if (!behind) return std::nullopt;
  behind->abscissa_a -= by;
  behind->abscissa_b -= by;
  return behind;
}

double angle_between(const Arm& a, const Arm& b) {
  const double from = heading(a, std::min(1.0, length(a.line)));
  const double to = heading(b, std::min(1.0, length(b.line)));
  const double turn = std::fmod(to - from + 4 * M_PI, 2 * M_PI);
  return turn > 2 * M_PI - same_angle ? 0 : turn;
}

namespace {

double widest_half(const Course& course) {
  return std::max_element(
             course.begin(), course.end(),
             [](const CoursePiece& l, const CoursePiece& m) { return l.half < m.half; })
      ->half;
}

// Up to the arc its circle fits nowhere between the two: farther apart, one comes back there.
bool beside_each_other(const Course& a, const Course& b, const CornerArc& corner) {
  const Line on_a = walked(a, corner.abscissa_a), on_b = walked(b, corner.abscissa_b);
  if (on_a.empty() || on_b.empty()) return true;  // behind the node
  const double apart = widest_half(a) + widest_half(b) + 2 * corner.radius + 1e-3;
  const auto all_near = [&](const Line& line, const Line& other) {
    return std::all_of(line.begin(), line.end(),
                       [&](const Point& p) { return distance_to_line(p, other) <= apart; });
  };
  return all_near(on_a, on_b) && all_near(on_b, on_a);
}

// Where the kerbs cross first on the way out from the node; none where one of them only comes back
// to the other there.
template <class Street>
std::optional<CornerArc> kerb_crossing(const Street& a, const Street& b) {
  auto crossing = corner_arc(a, b, 0);
  if (crossing && !beside_each_other(course_of(a, +1), course_of(b, -1), *crossing))
    crossing.reset();
  return crossing;
}

// The kerb lines alone, where there is no arc: they cross, or one arm's flat end sticks out.
void solve_without_arc(const Arm& a, const Arm& b, double angle, double reach,
                       SolvedCorner& solved) {
  if (angle >= M_PI - same_angle) return;
  const auto crossing = kerb_crossing(a, b);
  const Point node = planar(a.line.front());
  if (crossing && distance(crossing->centre, node) <= reach) {
    solved.gap = {true, *crossing};
    solved.limit_a = crossing->abscissa_a;
    solved.limit_b = crossing->abscissa_b;
    return;
  }
  const Point along_a = position_at(a.line, 0).direction,
              along_b = position_at(b.line, 0).direction;
  solved.limit_b = std::max(0.0, dot(left_normal(along_a) * a.start_to(+1), along_b));
  solved.limit_a = std::max(0.0, dot(left_normal(along_b) * -b.start_to(-1), along_a));
}

SolvedCorner without_arc(const Arm& a, const Arm& b, const CornerWish& wish) {
  SolvedCorner solved;
  solved.method = wish.radius <= 0 ? Method::hypothesis : Method::no_arc;
  solve_without_arc(a, b, angle_between(a, b), wish.max_arc_distance, solved);
  solved.gap.sharp = wish.radius <= 0;
  return solved;
}

bool cuts(const CornerArc& arc, const Arm& arm) {
  return distance_to_line(arc.centre, arm.line) < half_towards(arm, arc.centre) + arc.radius - 1e-3;
}

// A street through its node, from some way behind it on the arm as which it goes on there.
Line through_node(const Arm& behind, const Arm& arm, double by) {
  Line line = reversed(planar(substring(behind.line, 0, by)));
  const Line on = planar(arm.line);
  line.insert(line.end(), on.begin() + 1, on.end());
  return line;
}

// The corner of a and b where one of them comes out from under the kerb of a third arm, as which
// the other one goes on with the same kerb.  It lies behind the node of that other one.
std::optional<CornerArc> corner_on_third(const Arm& a, const Arm& b, const Arm& third,
                                         const CornerWish& wish) {
  const double half_a = a.start_to(+1), half_b = b.start_to(-1);
  const double by = std::min(length(third.line), wish.max_arc_distance);
  const bool behind_a = nearly_in_line(angle_between(a, third)) &&
                        std::abs(third.start_to(-1) - half_a) <= same_width;
  const bool behind_b = nearly_in_line(angle_between(third, b)) &&
                        std::abs(third.start_to(+1) - half_b) <= same_width;
  if (behind_a == behind_b) return std::nullopt;
  auto arc = corner_arc(behind_a ? through_node(third, a, by) : a.line,
                        behind_b ? through_node(third, b, by) : b.line, 2 * half_a, 2 * half_b,
                        wish.radius, planar(a.line.front()));
  if (!arc) return std::nullopt;
  (behind_a ? arc->abscissa_a : arc->abscissa_b) -= by;
  const bool behind_node = (behind_a ? arc->abscissa_a : arc->abscissa_b) < 0;
  const bool near = distance(arc->centre, planar(a.line.front())) <= wish.max_arc_distance;
  if (!behind_node || !near || !wish.ends.hold(*arc)) return std::nullopt;
  return arc;
}

}  // namespace

std::vector<std::size_t> counter_clockwise(const std::vector<Arm>& arms) {
  // To the millimetre: lines that are drawn twice may differ by noise.
  const auto rank = [&](std::size_t i) {
    return std::tuple(-arms[i].half_start, -std::round(length(arms[i].line) * 1000), i);
  };
  return leaving_order(
      arms.size(),
      [&](std::size_t i, double at) {
        return heading(arms[i], std::min(at, length(arms[i].line)));
      },
      [&](std::size_t i, std::size_t j) { return rank(i) < rank(j); });
}

namespace {

const Point& start_of(const Arm& arm) { return arm.line.front(); }
const Point& start_of(const Course& course) { return course.front().line.front(); }

const Line& first_line(const Arm& arm) { return arm.line; }
const Line& first_line(const Course& course) { return course.front().line; }

bool straight_until(const Line& line, double abscissa) {
  return abscissa <= distance(line[0], line[1]);
}

// What lies between kerbs that part by an angle and an arc that touches both: its length along them
// and its area, of a radius of 1 m.
struct Fillet {
  double length, area;
};
Fillet fillet_at(double angle) {
  const double length = 1 / std::tan(angle / 2);
  return {length, length - (M_PI - angle) / 2};
}

// The largest radius of straight streets whose arc keeps to the bounds, by the angle from a to b.
double bounded_radius(double angle, const CornerArc& arc, const CornerWish& wish) {
  const Fillet unit_fillet = fillet_at(angle);
  const double along = arc.radius * unit_fillet.length;
  const double room =
      along + std::min(wish.ends.until_a - arc.abscissa_a, wish.ends.until_b - arc.abscissa_b);
  return std::min({wish.corner_length / unit_fillet.length, room / unit_fillet.length,
                   std::sqrt(wish.corner_area / unit_fillet.area)});
}

// The arc itself, or the one of the largest radius that ends no farther from the crossing of the
// kerbs, and closes no more ground from there on, than a corner may.
template <class Street>
std::optional<CornerArc> within_bounds(const Street& a, const Street& b, const CornerArc& arc,
                                       const CornerWish& wish) {
  constexpr double precision = 1e-7;
  const double farthest = std::max(arc.abscissa_a, arc.abscissa_b);
  if (farthest <= wish.corner_length && farthest * arc.radius <= wish.corner_area &&
      wish.ends.hold(arc))
    return arc;
  const Line &on_a = first_line(a), &on_b = first_line(b);
  if (straight_until(on_a, arc.abscissa_a) && straight_until(on_b, arc.abscissa_b)) {
    const Point u = on_a[1] - on_a[0], v = on_b[1] - on_b[0];
    const double angle = std::atan2(cross(u, v), dot(u, v));
    if (angle <= 0) return arc;
    const double radius = bounded_radius(angle, arc, wish);
    if (radius <= 0) return std::nullopt;
    return radius < arc.radius ? corner_arc(a, b, radius) : arc;
  }
  const auto crossing = kerb_crossing(a, b);
  if (!crossing) return std::nullopt;
  const Course course_a = course_of(a, +1), course_b = course_of(b, -1);
  const auto fits = [&](const CornerArc& tried) {
    if (!wish.ends.hold(tried) || tried.abscissa_a - crossing->abscissa_a > wish.corner_length ||
        tried.abscissa_b - crossing->abscissa_b > wish.corner_length)
      return false;
    const Polygon ground = cusp(course_a, course_b, *crossing, tried);
    return ground.empty() || std::abs(signed_area(ground.front())) <= wish.corner_area;
  };
  if (fits(arc)) return arc;
  std::optional<CornerArc> found;
  for (double low = 0, high = arc.radius; high - low > precision;) {
    const double middle = (low + high) / 2;
    const auto tried = corner_arc(a, b, middle);
    const bool is_within = tried && fits(*tried);
    (is_within ? low : high) = middle;
    if (is_within) found = tried;
  }
  return found;
}

// On two arms, or on two courses.
template <class Street>
std::optional<SolvedCorner> solve_arc(const Street& a, const Street& b, double angle,
                                      const CornerWish& wish) {
  if (angle > widest_corner || wish.radius <= 0) return std::nullopt;
  SolvedCorner solved;
  const Point node = planar(start_of(a));
  const auto near = [&](const CornerArc& c) {
    return distance(c.centre, node) <= wish.max_arc_distance;
  };
  auto found = corner_arc(a, b, wish.radius);
  if (!found && angle < nearly_straight) {
    const auto largest = max_corner_radius(a, b, wish.radius);
    if (largest && *largest > 0.001) found = corner_arc(a, b, *largest);
    solved.method = Method::radius_reduced;
    solved.too_short = true;
  }
  if (found && !wish.by_hand) {
    const double fitting = found->radius;
    found = within_bounds(a, b, *found, wish);
    if (found && found->radius < wish.radius) solved.method = Method::radius_reduced;
    if (found && found->radius < fitting) solved.too_short = false;
  }
  if (found && !near(*found)) {
    double least = std::min(wish.radius_minimal, found->radius);
    solved.method = Method::radius_minimal;
    for (double high = found->radius; wish.by_hand && high - least > 1e-7;) {
      const double middle = (least + high) / 2;
      const auto tried = corner_arc(a, b, middle);
      (tried && near(*tried) ? least : high) = middle;
      if (least == middle) solved.method = Method::radius_reduced;
    }
    found = corner_arc(a, b, least);
    if (found && !near(*found) && angle >= nearly_straight) found.reset();
  }
  // Borders that are one line touch the circle in one point: no arc is needed.
  if (!found || distance(found->arc.start, found->arc.end) < shortest_arc) return std::nullopt;
  solved.gap = {true, *found};
  solved.limit_a = found->abscissa_a;
  solved.limit_b = found->abscissa_b;
  return solved;
}

}  // namespace

SolvedCorner solve_corner(const Arm& a, const Arm& b, const CornerWish& wish) {
  const auto solved = solve_arc(a, b, angle_between(a, b), wish);
  return solved ? *solved : without_arc(a, b, wish);
}

SolvedCorner solve_corner(const std::vector<const Arm*>& arms, std::size_t i,
                          const CornerWish& wish) {
  const std::size_t next = (i + 1) % arms.size();
  const Arm &a = *arms[i], &b = *arms[next];
  const double angle = angle_between(a, b);
  SolvedCorner solved = solve_corner(a, b, wish);
  for (std::size_t third = 0; solved.gap.corner.radius > 0 && third < arms.size(); ++third) {
    if (third == i || third == next || !cuts(solved.gap.corner, *arms[third])) continue;
    if (const auto arc = corner_on_third(a, b, *arms[third], wish)) {
      solved = {};
      solved.gap = {true, *arc};
      solved.limit_a = std::max(0.0, arc->abscissa_a);
      solved.limit_b = std::max(0.0, arc->abscissa_b);
      break;
    }
    if (angle >= nearly_straight) solved = without_arc(a, b, wish);
  }
  solved.gap.angle = angle;
  return solved;
}

bool may_follow(const Arm& a, const Arm& b) { return angle_between(a, b) < nearly_straight; }

std::optional<SolvedCorner> follow_corner(const Arm& a, const Arm& b, const Course& onwards_a,
                                          const Course& onwards_b, const CornerWish& wish) {
  auto solved = solve_arc(onwards_a, onwards_b, angle_between(a, b), wish);
  if (!solved || !beside_each_other(onwards_a, onwards_b, solved->gap.corner)) return std::nullopt;
  const auto crossing = kerb_crossing(onwards_a, onwards_b);
  if (!crossing) return std::nullopt;
  solved->gap.angle = angle_between(a, b);
  solved->gap.beyond = cusp(onwards_a, onwards_b, *crossing, solved->gap.corner);
  solved->gap.meets = false;
  solved->method = Method::followed;
  return solved;
}

void widen_limits(Arm& a, Arm& b, const SolvedCorner& corner) {
  a.asked_left = std::min(corner.limit_a, length(a.line));
  b.asked_right = std::min(corner.limit_b, length(b.line));
  a.limit = std::max(a.limit, a.asked_left);
  b.limit = std::max(b.limit, b.asked_right);
}

double kerb_clear_limit(const Arm& arm, double limit) {
  const double total = length(arm.line);
  const auto clear = [&](double abscissa) {
    poll_cancel();
    const double window = 2 * (half_at(arm, abscissa, +1) + half_at(arm, abscissa, -1));
    const Line near =
        substring(arm.line, std::max(0.0, abscissa - window), std::min(total, abscissa + window));
    if (near.size() <= 2) return true;
    const double given = std::abs(arm.half_end - arm.half_start) / std::max(total, 1e-9) * window;
    const Line border = border_across(arm, abscissa);
    const auto lies_behind = [&](int side) {
      const double half = half_at(arm, abscissa, side);
      return comes_within(border[side > 0 ? 0 : 1], near, half - given - 1e-4);
    };
    return !lies_behind(+1) && !lies_behind(-1);
  };
  if (limit >= total || clear(limit)) return limit;
  const auto wider = [&](double abscissa) {
    return std::max(half_at(arm, abscissa, +1), half_at(arm, abscissa, -1));
  };
  std::vector<double> tries;
  double abscissa = 0;
  for (std::size_t i = 1; i + 1 < arm.line.size(); ++i) {
    abscissa += distance(arm.line[i - 1], arm.line[i]);
    if (abscissa > limit + 4 * wider(limit) + 20) break;
    const Point before = unit(arm.line[i] - arm.line[i - 1]);
    const Point after = unit(arm.line[i + 1] - arm.line[i]);
    const double turn = std::abs(std::atan2(cross(before, after), dot(before, after)));
    const double clear_by = wider(abscissa) * std::tan(std::min(turn, 3.0) / 2);
    tries.push_back(abscissa + std::max(clear_by, 0.1) + 1e-6);
  }
  for (double step = 0.25; step <= 20; step += 0.25) tries.push_back(limit + step);
  std::sort(tries.begin(), tries.end());
  for (const double candidate : tries)
    if (candidate > limit && candidate < total && clear(candidate)) return candidate;
  return limit;
}

}  // namespace streetgen
