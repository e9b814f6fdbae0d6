#include "roadway/solve_corners.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "layout/node_corner.hpp"
#include "layout/width_transition.hpp"
#include "ramp/find_ramps.hpp"
#include "roadway/continued_course.hpp"
#include "roadway/crossing_middle.hpp"
#include "roadway/island.hpp"
#include "roadway/near_limits.hpp"
#include "roadway/nose.hpp"
#include "roadway/shared_ground.hpp"
#include "roadway/shared_kerb.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/progress.hpp"
#include "support/infinite.hpp"

namespace streetgen {

namespace {

std::pair<int, double> rank(const StreetAxis& axis) { return {axis.importance, -axis.width}; }

double wanted_radius(const StreetAxis& a, const StreetAxis& b, RadiusRule rule) {
  if (a.radius <= 0 || b.radius <= 0) return 0;
  switch (rule) {
    case RadiusRule::max:
      return std::max(a.radius, b.radius);
    case RadiusRule::mean:
      return (a.radius + b.radius) / 2;
    case RadiusRule::major:
      if (rank(a) != rank(b)) return (rank(a) < rank(b) ? a : b).radius;
      break;
    case RadiusRule::min:
      break;
  }
  return std::min(a.radius, b.radius);
}

// Between ends[i] and the next; it closes no more than `ground` square metres.
SolvedCorner solve(const Layout& layout, Junction& junction, std::size_t i, double radius,
                   bool by_hand, const ArcEnds& ends = {}, double ground = infinite) {
  const StreetSettings& settings = layout.settings;
  std::vector<const Arm*> arms;
  arms.reserve(junction.ends.size());
  for (const EdgeEnd& end : junction.ends) arms.push_back(&layout.arm(end));
  const CornerWish wish{radius,  settings.max_arc_distance, settings.radius_minimal,
                        by_hand, settings.corner_length,    std::min(settings.corner_area, ground),
                        ends};
  SolvedCorner solved = solve_corner(arms, i, wish);
  solved.ends = ends;
  solved.ground = ground;
  const EdgeEnd &a = junction.ends[i], &b = junction.next(i);
  const Arm &arm_a = layout.arm(a), &arm_b = layout.arm(b);
  // By hand, a corner is as it is wanted.
  const auto ended = [&](const SolvedCorner& corner, const Course& on_a, const Course& on_b) {
    if (by_hand || corner.gap.corner.radius <= 0) return corner;
    return nose(on_a, on_b, corner, wish, settings).value_or(corner);
  };
  const bool follows = solved.method == Method::no_arc ||
                       (solved.too_short && settings.short_axis == ShortAxis::follow);
  if (follows && !ends.bound() && may_follow(arm_a, arm_b)) {
    const Course on_a = continued_course(layout, a, +1, junction.followed);
    const Course on_b = continued_course(layout, b, -1, junction.followed);
    const auto followed = follow_corner(arm_a, arm_b, on_a, on_b, wish);
    if (followed && !(solved.too_short && followed->too_short)) return ended(*followed, on_a, on_b);
  }
  return ended(solved, course_of(arm_a, +1), course_of(arm_b, -1));
}

double wanted_at(const Layout& layout, const CornerPlace& at) {
  const Junction& junction = layout.junctions[at.node];
  const double wanted =
      wanted_radius(layout.axis_of(junction.ends[at.gap].edge),
                    layout.axis_of(junction.next(at.gap).edge), layout.settings.radius_rule);
  return ramp_corner(layout, junction, at.gap) == RampCorner::nose
             ? std::min(wanted, layout.settings.island_nose_radius)
             : wanted;
}

// Sharp corners of one node would make a square of it.
void share_ground(Layout& layout, int node, std::vector<SolvedCorner>& corners) {
  std::vector<double> wanted;
  std::vector<CornerGround> grounds;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    wanted.push_back(wanted_at(layout, {node, i}));
    grounds.push_back(corner_ground(corners[i], wanted[i]));
  }
  const std::vector<double> shares = shared_ground(grounds, layout.settings.corner_area);
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (shares[i] < infinite)
      corners[i] = solve(layout, layout.junctions[node], i, wanted[i], false, {}, shares[i]);
}

// As the axes want them.
SolvedCorners solve_all(Layout& layout) {
  SolvedCorners solved(layout.junctions.size());
  for (int n = 0; n < static_cast<int>(layout.junctions.size()); ++n) {
    Junction& junction = layout.junctions[n];
    if (junction.dead_end()) continue;
    poll_cancel();
    tell_progress("corners", n, layout.junctions.size());
    for (std::size_t i = 0; i < junction.ends.size(); ++i)
      solved[n].push_back(solve(layout, junction, i, wanted_at(layout, {n, i}), false));
    share_ground(layout, n, solved[n]);
  }
  return solved;
}

// The arcs of two corners do not lie upon each other on the kerb between them.
void part_arcs(Layout& layout, SolvedCorners& solved) {
  share_kerbs(layout, solved);
  for (int n = 0; n < static_cast<int>(solved.size()); ++n)
    for (std::size_t i = 0; i < solved[n].size(); ++i) {
      const ArcEnds ends = solved[n][i].ends;
      if (ends.bound())
        solved[n][i] = solve(layout, layout.junctions[n], i, wanted_at(layout, {n, i}), false, ends,
                             solved[n][i].ground);
    }
}

// On an island that its fillets would swallow each corner is a nose.
void keep_island(Layout& layout, const StreetFace& face, SolvedCorners& solved) {
  const double radius = layout.settings.island_nose_radius;
  for (const auto& [end, at] : face) {
    Junction& junction = layout.junctions[at.node];
    if (junction.dead_end()) continue;
    SolvedCorner& corner = solved[at.node][at.gap];
    if (corner.gap.corner.radius <= radius) continue;
    const SolvedCorner nose = solve(layout, junction, at.gap, radius, false, corner.ends);
    if (nose.gap.corner.radius <= 0) continue;
    corner = nose;
    corner.method = Method::nose;
  }
}

// The middle of two dual carriageways that cross is roadway, which has no corners; so is ground of
// which fillets would leave no more than a hole.
void pave(Layout& layout, const StreetFace& face, SolvedCorners& solved) {
  const std::vector<MiddlePart> parts = parts_of_middle(layout, face);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto& [node, gap] = face[i].corner;
    SolvedCorner& corner = solved[node][gap];
    corner = solve(layout, layout.junctions[node], gap, 0, false);
    corner.method = Method::no_arc;
    corner.gap.beyond = parts[i].ground;
    corner.limit_a = parts[i].limit_a;
    corner.limit_b = parts[i].limit_b;
  }
}

void settle_small_faces(Layout& layout, SolvedCorners& solved) {
  std::vector<StreetFace> islands, paved;
  for (StreetFace& face : small_faces(layout)) {
    // Ground is paved on one level alone.
    const bool may_be_paved = on_one_level(layout, face);
    if (may_be_paved && is_middle_of_crossing(layout, face))
      paved.push_back(std::move(face));
    else if (swallowed_island(layout, solved, face))
      islands.push_back(std::move(face));
    else if (may_be_paved && leaves_hole(layout, solved, face))
      paved.push_back(std::move(face));
  }
  for (const StreetFace& face : islands) keep_island(layout, face, solved);
  for (const StreetFace& face : paved) pave(layout, face, solved);
}

// Whether a kerb goes on nearly straight farther from or nearer to the axis, where none leaves.
bool tapers(const Arm& a, const Arm& b, double angle) {
  return nearly_in_line(angle) && sideways(a, b) > same_width;
}

// Whether two streets leave their node on one line, as far as the order about the node looks.
bool leave_together(const Arm& a, const Arm& b) {
  for (double at = 1; at <= 32; at *= 2) {
    const Point on_a = position_at(a.line, std::min(at, length(a.line))).point,
                on_b = position_at(b.line, std::min(at, length(b.line))).point;
    if (distance_to_line(on_a, b.line) > same_site && distance_to_line(on_b, a.line) > same_site)
      return false;
  }
  return true;
}

// Whether a wider street lies on this one: the kerb is that of the wider, and no mirror tells on
// which side of it this one lies.
bool within_wider(const Layout& layout, const Junction& junction, const EdgeEnd& end) {
  const Arm& own = layout.arm(end);
  return std::any_of(junction.ends.begin(), junction.ends.end(), [&](const EdgeEnd& other) {
    const Arm& arm = layout.arm(other);
    return slot(other) != slot(end) && arm.half_start > own.half_start + same_width &&
           arm.start_to(+1) >= own.start_to(+1) && arm.start_to(-1) >= own.start_to(-1) &&
           leave_together(own, arm);
  });
}

// Where three edges and more meet, the kerb of such a street needs no arc.
void make_tapers(const Layout& layout, SolvedCorners& solved) {
  for (std::size_t n = 0; n < solved.size(); ++n) {
    const Junction& junction = layout.junctions[n];
    if (junction.ends.size() < 3) continue;
    for (std::size_t i = 0; i < solved[n].size(); ++i) {
      SolvedCorner& corner = solved[n][i];
      const double angle = corner.gap.angle;
      const EdgeEnd &a = junction.ends[i], &b = junction.next(i);
      if (!tapers(layout.arm(a), layout.arm(b), angle) || within_wider(layout, junction, a) ||
          within_wider(layout, junction, b))
        continue;
      corner = {};
      corner.method = Method::transition;
      corner.gap.angle = angle;
      corner.gap.tapers = true;
    }
  }
}

// The limit of an end as its corners ask for it, but for the outer one of a ramp.
double limit_by_corners(const Layout& layout, const EdgeEnd& end, const SolvedCorners& solved) {
  const Edge& edge = layout.streets.network.edges[end.edge];
  const int node = end.at_start ? edge.from_node : edge.to_node;
  const Junction& junction = layout.junctions[node];
  if (junction.transition) return transition_limit(layout.arm(end), *junction.transition->length);
  double limit = 0;
  for (std::size_t i = 0; i < solved[node].size(); ++i) {
    if (ramp_corner(layout, junction, i) == RampCorner::outer) continue;
    if (slot(junction.ends[i]) == slot(end)) limit = std::max(limit, solved[node][i].limit_a);
    if (slot(junction.next(i)) == slot(end)) limit = std::max(limit, solved[node][i].limit_b);
  }
  return limit;
}

// The outer kerb of a ramp is that of the link up to its bend, and that of the highway from there
// on; straight where the link has no room for it.
void bend_ramps(const Layout& layout, SolvedCorners& solved) {
  for (const Ramp& ramp : layout.streets.ramps) {
    const Junction& junction = layout.junctions[ramp.node];
    const EdgeEnd link{ramp.link, ramp.link_at_start}, far{ramp.link, !ramp.link_at_start};
    const double nose = limit_by_corners(layout, link, solved);
    const double room = room_on_link(layout, ramp, limit_by_corners(layout, far, solved));
    for (std::size_t i = 0; i < junction.ends.size(); ++i) {
      if (ramp_corner(layout, junction, i) != RampCorner::outer) continue;
      const auto kerb = outer_kerb(layout, junction, i, nose, room);
      SolvedCorner& corner = solved[ramp.node][i];
      const double angle = corner.gap.angle;
      corner = {};
      corner.gap.angle = angle;
      corner.method = Method::transition;
      corner.gap.meets = kerb.has_value();
      corner.gap.tapers = corner.gap.direct = !kerb;
      if (!kerb) continue;
      corner.gap.corner = *kerb;
      corner.limit_a = std::max(0.0, kerb->abscissa_a);
      corner.limit_b = std::max(0.0, kerb->abscissa_b);
    }
  }
}

SolvedCorner solved_by_hand(Layout& layout, const CornerPlace& at, double radius) {
  SolvedCorner corner = solve(layout, layout.junctions[at.node], at.gap, radius, true);
  if (corner.gap.corner.radius == radius) corner.method = Method::by_hand;
  return corner;
}

// A corner by hand has no part in what becomes of the others.  In the middle of dual carriageways
// that cross, its part of the ground stays roadway.
void solve_by_hand(Layout& layout, const RadiiByHand& by_hand, SolvedCorners& solved) {
  for (const auto& [at, radius] : by_hand) {
    if (layout.junctions[at.first].dead_end()) continue;
    SolvedCorner& corner = solved[at.first][at.second];
    SolvedCorner put = solved_by_hand(layout, {at.first, at.second}, radius);
    if (corner.method == Method::no_arc && !corner.gap.beyond.empty()) {
      put.gap.beyond = std::move(corner.gap.beyond);
      put.limit_a = std::max(put.limit_a, corner.limit_a);
      put.limit_b = std::max(put.limit_b, corner.limit_b);
    }
    corner = std::move(put);
  }
}

// Streets of two levels share no ground, and ramps and highways with merging lanes have limits of
// their own.
void bring_limits_near(const Layout& layout, const RadiiByHand& by_hand, SolvedCorners& solved) {
  std::set<int> with_merging_lanes;
  for (const MergingRun& run : layout.merging_runs)
    for (const EdgeEnd& end : run.edges) with_merging_lanes.insert(end.edge);
  const auto level_of = [&](const EdgeEnd& end) {
    return layout.streets.network.edges[end.edge].level;
  };
  for (int n = 0; n < static_cast<int>(solved.size()); ++n) {
    const Junction& junction = layout.junctions[n];
    if (junction.ends.size() < 3) continue;
    for (std::size_t i = 0; i < solved[n].size(); ++i) {
      const EdgeEnd &a = junction.ends[i], &b = junction.next(i);
      if (level_of(a) == level_of(b) && by_hand.count({n, i}) == 0 &&
          with_merging_lanes.count(a.edge) == 0 && with_merging_lanes.count(b.edge) == 0 &&
          ramp_corner(layout, junction, i) == RampCorner::none)
        bring_limits_near(layout.arm(a), layout.arm(b), layout.settings.limit_distance,
                          solved[n][i]);
    }
  }
}

Corner corner_of(const Junction& junction, const CornerPlace& at, double radius_wanted,
                 const SolvedCorner& solved) {
  const EdgeEnd &a = junction.ends[at.gap], &b = junction.next(at.gap);
  Corner corner{at.node,       a.edge, a.at_start, b.edge, b.at_start,
                radius_wanted, 0,      {},         {},     solved.method};
  if (solved.gap.corner.radius > 0) {
    corner.radius = solved.gap.corner.radius;
    corner.centre = solved.gap.corner.centre;
    corner.arc = solved.gap.corner.arc;
  }
  return corner;
}

void append_corner(Layout& layout, const CornerPlace& at, double radius_wanted,
                   SolvedCorner& solved) {
  Junction& junction = layout.junctions[at.node];
  widen_limits(layout.arm(junction.ends[at.gap]), layout.arm(junction.next(at.gap)), solved);
  layout.streets.corners.push_back(corner_of(junction, at, radius_wanted, solved));
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
  if (junction.transition->length) return;
  junction.transition_yields = true;
  const EdgeEnd &a = junction.ends[0], &b = junction.ends[1];
  junction.transition->length = taper_length(
      std::max(sideways(layout.arm(a), layout.arm(b)), sideways(layout.arm(b), layout.arm(a))),
      std::max(layout.axis_of(a.edge).speed, layout.axis_of(b.edge).speed),
      layout.settings.taper_ratio);
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
    arm.limit = transition_limit(arm, *junction.transition->length);
  }
}

// A taper as long as its speed wants begins no nearer to the corners at the other end of an edge
// than these reach: the roadway of their fillets keeps its width.
void yield_to_corners(Layout& layout) {
  for (const Junction& junction : layout.junctions) {
    if (!junction.transition_yields) continue;
    for (const EdgeEnd& end : junction.ends) {
      Arm& arm = layout.arm(end);
      const double room = length(arm.line) - layout.arm({end.edge, !end.at_start}).limit;
      arm.limit = std::min(arm.limit, std::max(room, least_limit(arm)));
    }
  }
}

// Square metres: less between two edges that go on straight is no intersection.
constexpr double least_intersection = 0.01;

// Whether two arms of one width leave in nearly opposite directions, with no arc between.
bool goes_straight_on(const Arm& a, const Arm& b, const std::vector<Gap>& gaps) {
  if (!as_wide(a, b)) return false;
  if (gaps[0].corner.radius > 0 || gaps[1].corner.radius > 0) return false;
  const Point from = unit(a.line[1] - a.line[0]), to = unit(b.line[1] - b.line[0]);
  const double turn = std::abs(std::atan2(cross(from, to), -dot(from, to)));
  // Two wedges that end on the bisector, one on each side.
  const double wider = std::max(a.start_to(+1), a.start_to(-1));
  return wider * wider * turn < least_intersection;
}

// The border lines of both edges are one, across the node.
void meet_straight(Layout& layout, Junction& junction) {
  junction.straight = true;
  for (const EdgeEnd& end : junction.ends) layout.arm(end).limit = 0;
}

}  // namespace

void solve_joints(Layout& layout, const RadiiByHand& by_hand) {
  for (const MergingRun& run : layout.merging_runs)
    for (std::size_t k = 1; k < run.edges.size(); ++k) {
      const Edge& edge = layout.streets.network.edges[run.edges[k].edge];
      const int node = run.edges[k].at_start ? edge.from_node : edge.to_node;
      Junction& junction = layout.junctions[node];
      if (junction.straight) continue;
      for (std::size_t i = 0; i < 2; ++i) {
        const CornerPlace at{node, i};
        const auto put = by_hand.find({node, i});
        const double wanted = put != by_hand.end() ? put->second : wanted_at(layout, at);
        const SolvedCorner solved = put != by_hand.end()
                                        ? solved_by_hand(layout, at, wanted)
                                        : solve(layout, junction, i, wanted, false);
        corner_row(layout, at) = corner_of(junction, at, wanted, solved);
        junction.gaps[i] = solved.gap;
      }
    }
}

void solve_corners(Layout& layout, const RadiiByHand& by_hand) {
  choose_transitions(layout);
  SolvedCorners solved = solve_all(layout);
  if (layout.settings.corner_length < infinite) part_arcs(layout, solved);
  if (layout.settings.island_area > 0) settle_small_faces(layout, solved);
  if (!layout.settings.transition.length) make_tapers(layout, solved);
  bend_ramps(layout, solved);
  solve_by_hand(layout, by_hand, solved);
  bring_limits_near(layout, by_hand, solved);
  for (int n = 0; n < static_cast<int>(layout.junctions.size()); ++n) {
    Junction& junction = layout.junctions[n];
    if (junction.dead_end()) continue;
    for (std::size_t i = 0; i < junction.ends.size(); ++i) {
      const auto put = by_hand.find({n, i});
      const double wanted = put != by_hand.end() ? put->second : wanted_at(layout, {n, i});
      append_corner(layout, {n, i}, wanted, solved[n][i]);
    }
    if (junction.ends.size() == 2) {
      if (junction.transition)
        make_transition(layout, junction);
      else if (goes_straight_on(layout.arm(junction.ends[0]), layout.arm(junction.ends[1]),
                                junction.gaps))
        meet_straight(layout, junction);
      continue;
    }
    for (const EdgeEnd& end : junction.ends) {
      Arm& arm = layout.arm(end);
      arm.limit = std::max(arm.limit, least_limit(arm));
    }
  }
  yield_to_corners(layout);
  extend_limits(layout);
}

}  // namespace streetgen
