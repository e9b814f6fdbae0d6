#include "roadway/continued_course.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "layout/node_corner.hpp"
#include "layout/width_transition.hpp"

namespace streetgen {

namespace {

bool same_half(double a, double b) { return std::abs(a - b) <= same_width; }

bool widens(const Arm& arm) {
  return !arm.merging.empty() || !same_half(arm.half_start, arm.half_end);
}

// Whether a street goes on from one arm's end as the other with both kerbs in one line.
bool keeps_width(const Arm& last, const Arm& next) {
  return same_half(next.start_to(+1), last.end_to(+1)) &&
         same_half(next.start_to(-1), last.end_to(-1));
}

// The place of an edge in the order about its far node, at which the edge comes in.
std::size_t place_in(const Junction& junction, const EdgeEnd& last) {
  std::size_t in = 0;
  while (slot(junction.ends[in]) != slot({last.edge, !last.at_start})) ++in;
  return in;
}

// The same street: of the axes of the same level and width the one that turns least, of those that
// turn as much the one on the side of the kerb.
const EdgeEnd* alike(const Layout& layout, const EdgeEnd& last, const Junction& junction,
                     int side) {
  const auto& edges = layout.streets.network.edges;
  const Arm& own = layout.arm(last);
  const Point direction = unit(own.line.back() - own.line[own.line.size() - 2]);
  const std::size_t count = junction.ends.size(), in = place_in(junction, last);
  // From the kerb on.
  std::vector<std::pair<double, const EdgeEnd*>> ways;
  double least = widest_bend;
  for (std::size_t k = 1; k < count; ++k) {
    const EdgeEnd& other = junction.ends[(side > 0 ? in + count - k : in + k) % count];
    const Arm& on = layout.arm(other);
    const Point onwards = on.line[1] - on.line[0];
    const double turn = std::abs(std::atan2(cross(direction, onwards), dot(direction, onwards)));
    if (other.edge == last.edge || edges[other.edge].level != edges[last.edge].level ||
        !keeps_width(own, on) || widens(on) || turn >= widest_bend)
      continue;
    ways.push_back({turn, &other});
    least = std::min(least, turn);
  }
  const auto first = std::find_if(ways.begin(), ways.end(),
                                  [&](const auto& way) { return way.first <= least + same_angle; });
  return first == ways.end() ? nullptr : first->second;
}

// The axis along which the kerb goes on: the next one on its side, if it does not turn away.
const EdgeEnd* beside(const Layout& layout, const EdgeEnd& last, const Junction& junction,
                      int side) {
  const std::size_t count = junction.ends.size(), in = place_in(junction, last);
  const EdgeEnd& next = junction.ends[(in + (side > 0 ? count - 1 : 1)) % count];
  const Arm& on = layout.arm(next);
  const double bend = std::abs(angle_between(layout.arm(junction.ends[in]), on) - M_PI);
  return next.edge == last.edge || widens(on) || bend >= widest_bend ? nullptr : &next;
}

// How far before and behind the node the kerb changes.
struct Taper {
  double before = 0, after = 0;
};

Taper taper_of(const Layout& layout, const Junction& junction, const EdgeEnd& next, int side,
               bool first) {
  if (!junction.transition) return {};
  const int in = next.edge == junction.ends[0].edge ? 1 : 0;
  const Arm& last = layout.arm(junction.ends[in]);
  Taper taper{transition_limit(last, *junction.transition->length),
              transition_limit(layout.arm(next), *junction.transition->length)};
  // The limits of an edge that is followed cross.
  if (first) taper.before *= length(last.line) / (length(last.line) + taper.before);
  const int seen = in == junction.transition_from() ? side : -side;
  const TransitionKind kind = junction.transition->kind;
  if (kind == TransitionKind::symmetric || (kind == TransitionKind::left) == (seen > 0))
    return taper;
  const double half_step = step_length(taper.before, taper.after) / 2;
  return {half_step, half_step};
}

// Where the width steps at the node, the kerb runs across there.
Line kerb_between(const CoursePiece& last, const CoursePiece& next, const Line& node, int side) {
  if (node.size() > 1) return kerb_line(node, 0, length(node), last.half, next.half, side).line;
  const double size = length(last.line);
  Line kerb = kerb_line(last.line, size, size, last.half, last.half, side).line;
  kerb.push_back(kerb_line(next.line, 0, 0, next.half, next.half, side).line.front());
  return kerb;
}

void change_width(Course& course, const Arm& arm, const Taper& taper, int side) {
  CoursePiece& last = course.back();
  const double before = length(last.line), after = length(arm.line), at = last.end;
  Line node = substring(last.line, before - taper.before, before);
  const Line behind = substring(arm.line, 0, taper.after);
  node.insert(node.end(), behind.begin(), behind.end());
  last.line = substring(last.line, 0, before - taper.before);
  last.end = at - taper.before;
  const CoursePiece next{substring(arm.line, taper.after, after), arm.start_to(side),
                         at + taper.after, at + after};
  const CoursePiece kerb{kerb_between(last, next, distinct(planar(node)), side), 0, last.end,
                         next.start};
  course.push_back(kerb);
  course.push_back(next);
}

int node_of(const std::vector<Edge>& edges, const EdgeEnd& end) {
  return end.at_start ? edges[end.edge].from_node : edges[end.edge].to_node;
}

}  // namespace

Course continued_course(const Layout& layout, const EdgeEnd& end, int side,
                        std::vector<int>& looked_at) {
  const auto& edges = layout.streets.network.edges;
  const Arm& own = layout.arm(end);
  Course course = course_of(own, side);
  if (widens(own)) return course;
  EdgeEnd last = end;
  bool unbroken = true;  // nothing left between, on the side of the kerb
  const int node = node_of(edges, end);
  while (course.back().end < layout.settings.reach) {
    looked_at.push_back(node_of(edges, {last.edge, !last.at_start}));
    if (looked_at.back() == node) break;  // a street that comes back
    const Junction& junction = layout.junctions[looked_at.back()];
    const EdgeEnd* const kerb = unbroken ? beside(layout, last, junction, side) : nullptr;
    const EdgeEnd* next = alike(layout, last, junction, side);
    unbroken = next == nullptr || next == kerb;
    if (next == nullptr) next = kerb;
    if (next == nullptr) break;
    const Arm& arm = layout.arm(*next);
    if (same_half(layout.arm(last).start_to(side), arm.start_to(side))) {
      CoursePiece& street = course.back();
      street.line.insert(street.line.end(), arm.line.begin() + 1, arm.line.end());
      street.end += length(arm.line);
    } else {
      change_width(course, arm, taper_of(layout, junction, *next, side, last.edge == end.edge),
                   side);
    }
    last = *next;
  }
  return course;
}

}  // namespace streetgen
