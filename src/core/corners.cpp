#include "corners.hpp"

#include <algorithm>
#include <cmath>

#include "around.hpp"
#include "polyline.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/progress.hpp"
#include "transition.hpp"

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

// The arm with the axes that go on in its direction, up to the reach from the node: at each
// further node the one that turns least, within the widest bend, of the same level and width.
Arm longer(const Layout& layout, const EdgeEnd& end, std::vector<int>& followed) {
  const auto& edges = layout.streets.network.edges;
  Arm arm = layout.arm(end);
  if (arm.half_start != arm.half_end) return arm;
  EdgeEnd last = end;
  while (length(arm.line) < layout.settings.reach) {
    const Edge& edge = edges[last.edge];
    const Point direction = unit(arm.line.back() - arm.line[arm.line.size() - 2]);
    double best = std::cos(widest_bend);
    const EdgeEnd* next = nullptr;
    followed.push_back(last.at_start ? edge.to_node : edge.from_node);
    for (const EdgeEnd& other : layout.junctions[followed.back()].ends) {
      const Arm& on = layout.arm(other);
      const double cosine = dot(direction, unit(on.line[1] - on.line[0]));
      if (other.edge == last.edge || edges[other.edge].level != edge.level ||
          std::abs(on.half_start - arm.half_start) > same_width ||
          std::abs(on.half_end - arm.half_start) > same_width || cosine <= best)
        continue;
      best = cosine;
      next = &other;
    }
    if (next == nullptr) break;
    const Line& on = layout.arm(*next).line;
    arm.line.insert(arm.line.end(), on.begin() + 1, on.end());
    last = *next;
  }
  return arm;
}

// Between ends[i] and the next.
SolvedCorner solve(const Layout& layout, Junction& junction, std::size_t i, double radius,
                   bool by_hand) {
  const StreetSettings& settings = layout.settings;
  std::vector<const Arm*> arms;
  for (const EdgeEnd& end : junction.ends) arms.push_back(&layout.arm(end));
  const CornerWish wish{radius, settings.max_arc_distance, settings.radius_minimal, by_hand};
  SolvedCorner solved = solve_corner(arms, i, wish);
  const bool reduced = solved.method == Method::radius_reduced;
  if (solved.method != Method::no_arc && !(reduced && settings.short_axis == ShortAxis::follow))
    return solved;
  const EdgeEnd &a = junction.ends[i], &b = junction.next(i);
  const Arm &arm_a = layout.arm(a), &arm_b = layout.arm(b);
  if (!may_follow(arm_a, arm_b)) return solved;
  const auto followed = follow_corner(arm_a, arm_b, longer(layout, a, junction.followed),
                                      longer(layout, b, junction.followed), wish);
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

// Its two corners have no arc.
void make_transition(Layout& layout, Junction& junction) {
  choose_transition(layout, junction);
  auto& corners = layout.streets.corners;
  for (auto corner = corners.end() - 2; corner != corners.end(); ++corner) {
    corner->radius = 0;
    corner->centre.reset();
    corner->arc.reset();
    corner->method = Method::transition;
  }
  for (const EdgeEnd& end : junction.ends) {
    Arm& arm = layout.arm(end);
    arm.limit = std::min(junction.transition->length / 2, 0.4 * length(arm.line));
  }
}

}  // namespace

void solve_corners(Layout& layout, const RadiiByHand& by_hand) {
  for (int n = 0; n < static_cast<int>(layout.junctions.size()); ++n) {
    Junction& junction = layout.junctions[n];
    if (junction.dead_end()) continue;
    poll_cancel();
    tell_progress("corners", n, layout.junctions.size());
    for (std::size_t i = 0; i < junction.ends.size(); ++i) append_corner(layout, n, i, by_hand);
    if (junction.ends.size() == 2) {
      if (changes_width(layout.arm(junction.ends[0]), layout.arm(junction.ends[1])))
        make_transition(layout, junction);
      continue;
    }
    for (const EdgeEnd& end : junction.ends) {
      Arm& arm = layout.arm(end);
      arm.limit = std::max(arm.limit, least_limit(arm));
    }
  }
}

}  // namespace streetgen
