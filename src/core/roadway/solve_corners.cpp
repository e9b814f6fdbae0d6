#include "roadway/solve_corners.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"
#include "roadway/continued_course.hpp"
#include "roadway/node_corner.hpp"
#include "roadway/width_transition.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/progress.hpp"

namespace streetgen {

namespace {

double wanted_radius(const StreetAxis& a, const StreetAxis& b, RadiusRule rule) {
  if (a.radius <= 0 || b.radius <= 0) return 0;
  switch (rule) {
    case RadiusRule::max:
      return std::max(a.radius, b.radius);
    case RadiusRule::mean:
      return (a.radius + b.radius) / 2;
    case RadiusRule::min:
      break;
  }
  return std::min(a.radius, b.radius);
}

// Between ends[i] and the next.
SolvedCorner solve(const Layout& layout, Junction& junction, std::size_t i, double radius,
                   bool by_hand) {
  const StreetSettings& settings = layout.settings;
  std::vector<const Arm*> arms;
  arms.reserve(junction.ends.size());
  for (const EdgeEnd& end : junction.ends) arms.push_back(&layout.arm(end));
  const CornerWish wish{radius, settings.max_arc_distance, settings.radius_minimal, by_hand};
  SolvedCorner solved = solve_corner(arms, i, wish);
  const bool reduced = solved.method == Method::radius_reduced;
  if (solved.method != Method::no_arc && !(reduced && settings.short_axis == ShortAxis::follow))
    return solved;
  const EdgeEnd &a = junction.ends[i], &b = junction.next(i);
  const Arm &arm_a = layout.arm(a), &arm_b = layout.arm(b);
  if (!may_follow(arm_a, arm_b)) return solved;
  const auto followed =
      follow_corner(arm_a, arm_b, continued_course(layout, a, +1, junction.followed),
                    continued_course(layout, b, -1, junction.followed), wish);
  return followed && (!reduced || followed->gap.corner.radius >= radius) ? *followed : solved;
}

void append_corner(Layout& layout, int node, std::size_t i, const RadiiByHand& by_hand) {
  Junction& junction = layout.junctions[node];
  const EdgeEnd &a = junction.ends[i], &b = junction.next(i);
  const auto put = by_hand.find({node, i});
  const bool decided = put != by_hand.end();
  const double radius = decided ? put->second
                                : wanted_radius(layout.axis_of(a.edge), layout.axis_of(b.edge),
                                                layout.settings.radius_rule);
  SolvedCorner solved = solve(layout, junction, i, radius, decided);
  if (decided && solved.gap.corner.radius == radius) solved.method = Method::by_hand;
  widen_limits(layout.arm(a), layout.arm(b), solved);
  Corner corner{node, a.edge, a.at_start, b.edge, b.at_start, radius, 0, {}, {}, solved.method};
  if (solved.gap.corner.radius > 0) {
    corner.radius = solved.gap.corner.radius;
    corner.centre = solved.gap.corner.centre;
    corner.arc = solved.gap.corner.arc;
  }
  layout.streets.corners.push_back(corner);
  junction.gaps.push_back(std::move(solved.gap));
}

// Of two ends where the width changes each is an end of its axis.
void choose_transition(const Layout& layout, Junction& junction) {
  const auto key = [&](int i) {
    const EdgeEnd& end = junction.ends[i];
    return std::pair(layout.axis_of(end.edge).axis_id, !end.at_start);
  };
  const int smaller = key(0) < key(1) ? 0 : 1;
  junction.transition = layout.settings.transition;
  junction.along = smaller;
  for (const int i : {1 - smaller, smaller}) {
    const StreetAxis& axis = layout.axis_of(junction.ends[i].edge);
    const auto& own = junction.ends[i].at_start ? axis.transition_start : axis.transition_end;
    if (!own) continue;
    junction.transition = own;
    junction.along = i;
  }
}

void choose_transitions(Layout& layout) {
  for (Junction& junction : layout.junctions)
    if (junction.ends.size() == 2 &&
        changes_width(layout.arm(junction.ends[0]), layout.arm(junction.ends[1])))
      choose_transition(layout, junction);
}

// Its two corners have no arc.
void make_transition(Layout& layout, const Junction& junction) {
  auto& corners = layout.streets.corners;
  for (auto corner = corners.end() - 2; corner != corners.end(); ++corner) {
    corner->radius = 0;
    corner->centre.reset();
    corner->arc.reset();
    corner->method = Method::transition;
  }
  for (const EdgeEnd& end : junction.ends) {
    Arm& arm = layout.arm(end);
    arm.limit = transition_limit(arm, *junction.transition);
  }
}

}  // namespace

void solve_corners(Layout& layout, const RadiiByHand& by_hand) {
  choose_transitions(layout);
  for (int n = 0; n < static_cast<int>(layout.junctions.size()); ++n) {
    Junction& junction = layout.junctions[n];
    if (junction.dead_end()) continue;
    poll_cancel();
    tell_progress("corners", n, layout.junctions.size());
    for (std::size_t i = 0; i < junction.ends.size(); ++i) append_corner(layout, n, i, by_hand);
    if (junction.ends.size() == 2) {
      if (junction.transition) make_transition(layout, junction);
      continue;
    }
    for (const EdgeEnd& end : junction.ends) {
      Arm& arm = layout.arm(end);
      arm.limit = std::max(arm.limit, least_limit(arm));
    }
  }
}

}  // namespace streetgen
