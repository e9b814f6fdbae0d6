#include "layout/surface_ring.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "geometry/closed_ring.hpp"
#include "geometry/offset.hpp"
#include "geometry/polyline.hpp"
#include "geometry/surface_union.hpp"
#include "geometry/tolerance.hpp"
#include "layout/arm_cover.hpp"
#include "layout/drawn_arc.hpp"
#include "layout/surface_pieces.hpp"

namespace streetgen {

namespace {

// A ring in the making; `whole` ends once a piece did not fit.
struct Outline {
  Ring ring;
  bool whole = true;

  // The kerb's inner points: a border line or a corner already gave an end where one is left out.
  void follow(const Arm& arm, double u, double v, int side, bool with_first, bool with_last) {
    const auto [start, end] = halves(arm, u, v, side);
    follow(kerb_line(arm.line, u, v, start, end, side), with_first, with_last);
  }
  void follow(const KerbLine& kerb, bool with_first, bool with_last) {
    whole = whole && kerb.whole;
    for (std::size_t i = with_first ? 0 : 1; i + (with_last ? 0 : 1) < kerb.line.size(); ++i)
      ring.push_back(kerb.line[i]);
  }

  // An end of a border line, in the place of what the kerb before it gave there.
  void reach(const Point& border) {
    while (!ring.empty() && distance(ring.back(), border) <= same_place) ring.pop_back();
    ring.push_back(border);
  }
};

Point kerb_at_node(const Arm& arm, int side) {
  const auto [start, end] = halves(arm, 0, 0, side);
  return kerb_line(arm.line, 0, 0, start, end, side).line.front();
}

// An arc that starts where a border line ends starts at that end.
void append_corner(Ring& ring, const CornerArc& corner) {
  const Line arc = drawn_arc(corner);
  const bool starts_there = !ring.empty() && distance(ring.back(), arc.front()) <= same_place;
  ring.insert(ring.end(), arc.begin() + (starts_there ? 1 : 0), arc.end());
}

// From the foot of an arc to a limit beyond it: the foot may lie on the round outside of a bend.
KerbLine kerb_beyond(const Arm& arm, double foot_abscissa, const Point& foot, int side) {
  const double from = std::max(0.0, foot_abscissa);
  const double limit = arm.limit_on(side);
  const auto [start, end] = halves(arm, from, limit, side);
  KerbLine kerb = kerb_line(arm.line, from, limit, start, end, side);
  if (from == 0 || from > limit - least_piece) return kerb;
  const Point bend = planar(position_at(arm.line, from).point), first = kerb.line.front();
  if (distance(foot, first) <= same_place ||
      std::abs(distance(foot, bend) - distance(first, bend)) > same_place)
    return kerb;
  Line round{foot};
  append_arc(round, bend, foot, first, cross(foot - bend, first - bend) > 0, join_quarter);
  kerb.line.insert(kerb.line.begin(), round.begin(), round.end());
  return kerb;
}

// Where the circle touches the round end of an arm behind the node: along that end.
void append_round_end(Ring& ring, Point node, const Point& from, const Point& to) {
  ring.push_back(from);
  const Point in = from - node, out = to - node;
  if (cross(in, out) > 1e-9 || dot(in, out) < 0)
    append_arc(ring, node, from, to, true, join_quarter);
  ring.push_back(to);
}

// Whether the outside of a bend is round. Two streets of different width that leave within a right
// angle of each other are no bend but a fork: behind the node both end flat.
bool rounds(const Arm& a, const Arm& b, const Gap& gap) {
  return gap.angle > M_PI && (gap.angle < 3 * M_PI / 2 - same_angle || as_wide(a, b));
}

// The ground outside of a bend, whose kerb has one width at the node.
Polygon outside_of_bend(const Arm& a, const Arm& b, const Gap& gap) {
  const Point node = planar(a.line.front());
  if (!gap.tapers)
    return rounds(a, b, gap) ? fan(node, kerb_at_node(a, +1), kerb_at_node(b, -1)) : Polygon{{}};
  if (gap.angle <= M_PI) return {{}};
  const auto kerb = [&](const Arm& arm, int side) {
    return node +
           left_normal(position_at(arm.line, 0).direction) * (side * gap.taper.half_at_node());
  };
  return fan(node, kerb(a, +1), kerb(b, -1));
}

// The ground outside of the slight bends of streets that keep their width past other arms.
std::vector<Polygon> outside_of_streets(const std::vector<Arm>& arms,
                                        const std::vector<Gap>& gaps) {
  const std::size_t count = arms.size();
  const Point node = planar(arms.front().line.front());
  std::vector<Polygon> grounds;
  for (std::size_t i = 0; i < count; ++i) {
    double angle = gaps[i].angle;
    for (std::size_t k = 2; k < count; ++k) {
      angle += gaps[(i + k - 1) % count].angle;
      const Arm &a = arms[i], &b = arms[(i + k) % count];
      if (as_wide(a, b) && angle > M_PI + same_angle && nearly_in_line(angle))
        grounds.push_back(fan(node, kerb_at_node(a, +1), kerb_at_node(b, -1)));
    }
  }
  return grounds;
}

// From one arm through the node to the other, within their limits; straight where the bend between
// needs more than that leaves.
KerbLine tapering_kerb(const Arm& a, const Arm& b, const Taper& taper) {
  const double start = std::min(taper.reach_a, a.limit_on(+1)),
               end = std::min(taper.reach_b, b.limit_on(-1));
  Line line = substring(a.line, start, 0);
  const Line on = substring(b.line, 0, end);
  line.insert(line.end(), on.begin() + 1, on.end());
  line = distinct(planar(std::move(line)));
  KerbLine kerb =
      kerb_line(line, 0, length(line), taper.half_on_a(start), taper.half_on_b(end), -1);
  return kerb.whole && !taper.straight_on ? kerb : KerbLine{{kerb.line.front(), kerb.line.back()}};
}

// The kerb that tapers, and up to it those of the arms.
void append_taper(Outline& outline, const Arm& a, const Arm& b, const Taper& taper) {
  const double limit_a = a.limit_on(+1), limit_b = b.limit_on(-1);
  const bool along_a = taper.reach_a < limit_a, along_b = taper.reach_b < limit_b;
  if (along_a) outline.follow(a, limit_a, taper.reach_a, +1, false, false);
  outline.follow(tapering_kerb(a, b, taper), along_a, along_b);
  if (along_b) outline.follow(b, taper.reach_b, limit_b, -1, false, false);
}

void append_gap(Outline& outline, const Arm& a, const Arm& b, const Gap& gap) {
  const Point node = planar(a.line.front());
  if (gap.tapers) {
    if (!gap.direct) append_taper(outline, a, b, gap.taper);
    return;
  }
  if (!gap.meets) {
    outline.follow(a, a.limit_on(+1), 0, +1, false, true);
    if (rounds(a, b, gap))
      append_arc(outline.ring, node, kerb_at_node(a, +1), kerb_at_node(b, -1), true, join_quarter);
    outline.follow(b, 0, b.limit_on(-1), -1, true, false);
    return;
  }
  const CornerArc& corner = gap.corner;
  KerbLine towards = kerb_beyond(a, corner.abscissa_a, corner.arc.start, +1);
  towards.line = reversed(std::move(towards.line));
  outline.follow(towards, false, false);
  if (corner.abscissa_a == 0)
    append_round_end(outline.ring, node, kerb_at_node(a, +1), corner.arc.start);
  append_corner(outline.ring, corner);
  if (corner.abscissa_b == 0)
    append_round_end(outline.ring, node, corner.arc.end, kerb_at_node(b, -1));
  outline.follow(kerb_beyond(b, corner.abscissa_b, corner.arc.end, -1), false, false);
}

// Between the two axes and the arc: the ground that the corner adds.
Polygon fillet(const Arm& a, const Arm& b, const Gap& gap) {
  Ring ring = planar(substring(a.line, 0, std::max(0.0, gap.corner.abscissa_a)));
  if (gap.corner.abscissa_a == 0)
    append_round_end(ring, ring.front(), kerb_at_node(a, +1), gap.corner.arc.start);
  else if (gap.corner.abscissa_a < 0)
    ring.push_back(kerb_at_node(a, +1));
  append_corner(ring, gap.corner);
  const Line back = planar(substring(b.line, std::max(0.0, gap.corner.abscissa_b), 0));
  if (gap.corner.abscissa_b == 0)
    append_round_end(ring, back.back(), gap.corner.arc.end, kerb_at_node(b, -1));
  else if (gap.corner.abscissa_b < 0)
    ring.push_back(kerb_at_node(b, -1));
  ring.insert(ring.end(), back.begin(), back.end());
  return {closed(std::move(ring))};
}

// From the left end of one border to the right end of the other: straight, but out past the flat
// ends that their arms have at the node.
Line past_flat_ends(const Arm& a, const Arm& b) {
  Line kerb;
  for (const Point& p : {a.border[0], kerb_at_node(a, +1), kerb_at_node(b, -1), b.border[1]}) {
    while (kerb.size() > 1 && cross(kerb.back() - kerb[kerb.size() - 2], p - kerb.back()) <= 0)
      kerb.pop_back();
    kerb.push_back(p);
  }
  return kerb;
}

// Between two axes and the kerb past their flat ends.
Polygon between_axes(const Arm& a, const Arm& b) {
  Ring ring = planar(substring(a.line, 0, a.limit));
  const Line kerb = past_flat_ends(a, b);
  ring.insert(ring.end(), kerb.begin(), kerb.end());
  const Line back = planar(substring(b.line, b.limit, 0));
  ring.insert(ring.end(), back.begin(), back.end());
  return {closed(std::move(ring))};
}

WidthProfile::Place place_at(const Arm& arm, double abscissa) {
  return {abscissa, half_at(arm, abscissa, +1), half_at(arm, abscissa, -1)};
}

MultiPolygon arm_pieces(const Arm& arm, const WidthProfile& profile, double start, double end,
                        const Line& from, const Line& to) {
  const Line part = line_with_places(arm, profile, start, end);
  std::vector<double> left(part.size()), right(part.size());
  double abscissa = start;
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (i > 0) abscissa += distance(part[i - 1], part[i]);
    const WidthProfile::Place wide =
        profile.empty() ? place_at(arm, abscissa) : profile.at(abscissa);
    left[i] = wide.left;
    right[i] = wide.right;
  }
  return pieces(part, left, right, from, to);
}

// The kerb of a section, stretch by stretch of its profile.
KerbLine kerb_of(const Arm& arm, const WidthProfile& profile, double u, double v, int side) {
  if (profile.empty()) return kerb_line(arm.line, u, v, arm.start_to(side), arm.end_to(side), side);
  KerbLine kerb;
  const double total = length(arm.line);
  profile.of_side(side).each_stretch(
      std::min(u, v), std::max(u, v), [&](const auto& from, const auto& to) {
        const auto [start, end] =
            WidthProfile::extended(from.abscissa, from.on(side), to.abscissa, to.on(side), total);
        const KerbLine part = kerb_line(arm.line, from.abscissa, to.abscissa, start, end, side);
        kerb.line.insert(kerb.line.end(), part.line.begin(), part.line.end());
        kerb.whole = kerb.whole && part.whole;
      });
  if (u > v) kerb.line = reversed(std::move(kerb.line));
  return kerb;
}

// From one end of a section to the other along the kerb of a side, backwards where u > v, between
// what parts it from others at both ends.
void append_side(Outline& outline, const Arm& arm, const WidthProfile& profile, double u, double v,
                 int side, const std::optional<Parting>& first,
                 const std::optional<Parting>& last) {
  Ring& ring = outline.ring;
  if (first) ring.insert(ring.end(), first->line.begin() + 1, first->line.end());
  outline.follow(kerb_of(arm, profile, first ? first->until : u, last ? last->until : v, side),
                 false, false);
  if (last) ring.insert(ring.end(), last->line.rbegin(), last->line.rend() - 1);
}

// The ground within a simple outline; empty for any other outline.
MultiPolygon held_by(Geos& geos, Outline outline) {
  MultiPolygon held;
  if (!outline.whole || outline.ring.size() < 4 || !(signed_area(outline.ring) > 0)) return held;
  held.emplace_back().push_back(std::move(outline.ring));
  if (!geos.valid(held)) held.clear();
  return held;
}

}  // namespace

WidthProfile tapered(const std::vector<Arm>& arms, const std::vector<Gap>& gaps, std::size_t i) {
  const Arm& arm = arms[i];
  const Gap &left = gaps[i], &right = gaps[(i + gaps.size() - 1) % gaps.size()];
  const bool on_left = left.tapers && !left.direct, on_right = right.tapers && !right.direct;
  const bool parts_left = !left.parting.empty(), parts_right = !right.parting.empty();
  if (!on_left && !on_right && !parts_left && !parts_right) return {};
  const Point foot = planar(position_at(arm.line, arm.limit).point);
  // To the line that parts the sections behind the limit.
  const auto half_before = [&](double own, const Point& border, double abscissa) {
    return own + (distance(foot, border) - own) * abscissa / arm.limit;
  };
  std::set<double> abscissas{0, arm.limit};
  if (on_left) abscissas.insert(std::min(left.taper.reach_a, arm.limit));
  if (on_right) abscissas.insert(std::min(right.taper.reach_b, arm.limit));
  WidthProfile profile;
  for (const double abscissa : abscissas) {
    WidthProfile::Place place = place_at(arm, abscissa);
    if (on_left && abscissa < left.taper.reach_a) place.left = left.taper.half_on_a(abscissa);
    if (on_right && abscissa < right.taper.reach_b) place.right = right.taper.half_on_b(abscissa);
    if (parts_left) place.left = half_before(place.left, arm.border[0], abscissa);
    if (parts_right) place.right = half_before(place.right, arm.border[1], abscissa);
    profile.places.push_back(place);
  }
  return profile;
}

Polygon cusp(const Course& a, const Course& b, const CornerArc& crossing, const CornerArc& corner) {
  Outline outline;
  outline.ring.push_back(crossing.centre);
  outline.follow(kerb_line(a, crossing.abscissa_a, corner.abscissa_a, +1), false, false);
  append_corner(outline.ring, corner);
  outline.follow(kerb_line(b, corner.abscissa_b, crossing.abscissa_b, -1), false, false);
  outline.ring = closed(std::move(outline.ring));
  if (outline.ring.empty() || !outline.whole) return {};
  return {outline.ring};
}

Built build_section(Geos& geos, const Arm& arm, const WidthProfile& profile, double start,
                    double end, const Line& start_border, const Line& end_border,
                    const SectionPartings& partings) {
  const auto &left = partings.left, &right = partings.right;
  Outline outline;
  outline.reach(start_border[1]);
  append_side(outline, arm, profile, start, end, -1, right.at_start, right.at_end);
  outline.reach(end_border[1]);
  outline.reach(end_border[0]);
  append_side(outline, arm, profile, end, start, +1, left.at_end, left.at_start);
  outline.reach(start_border[0]);
  outline.ring = closed(std::move(outline.ring));
  MultiPolygon held = held_by(geos, std::move(outline));
  if (!held.empty()) return {std::move(held), false};
  MultiPolygon parts = arm_pieces(arm, profile, start, end, start_border, end_border);
  for (const auto& side : {left, right}) {
    if (side.at_start) parts.push_back({side.at_start->ground(arm.line, start)});
    if (side.at_end) parts.push_back({side.at_end->ground(arm.line, end)});
  }
  return {ending_on(geos, geos.polygons(geos.unite({parts}).get()), {start_border, end_border}),
          true};
}

Built build_intersection(Geos& geos, const std::vector<Arm>& arms, const std::vector<Gap>& gaps) {
  Outline outline;
  for (std::size_t i = 0; i < arms.size(); ++i) {
    outline.reach(arms[i].border[1]);
    outline.reach(arms[i].border[0]);
    if (gaps[i].parting.empty()) append_gap(outline, arms[i], arms[(i + 1) % arms.size()], gaps[i]);
  }
  outline.reach(arms.front().border[1]);
  outline.ring = closed(std::move(outline.ring));
  std::vector<Line> borders;
  for (const Arm& arm : arms) borders.push_back(arm.border);
  const auto whole = [&](const std::vector<MultiPolygon>& parts) {
    return ending_on(geos, united(geos, parts), borders);
  };
  std::vector<MultiPolygon> parts;
  for (const Gap& gap : gaps)
    if (!gap.beyond.empty()) parts.push_back({gap.beyond});
  MultiPolygon held = held_by(geos, std::move(outline));
  if (!held.empty() && covers(held, arms, gaps)) {
    if (parts.empty()) return {std::move(held), false};
    parts.push_back(std::move(held));
    return {whole(parts), false};
  }
  for (std::size_t i = 0; i < arms.size(); ++i) {
    const Arm &a = arms[i], &b = arms[(i + 1) % arms.size()];
    if (a.limit > 0)
      parts.push_back(arm_pieces(a, tapered(arms, gaps, i), 0, a.limit, {}, a.border));
    if (gaps[i].direct) {
      MultiPolygon ground{between_axes(a, b)};
      if (!ground.front().front().empty() && geos.valid(ground)) parts.push_back(std::move(ground));
    } else if (gaps[i].meets && gaps[i].parting.empty()) {
      const Polygon ground = fillet(a, b, gaps[i]);
      if (!ground.front().empty()) parts.push_back({ground});
    } else if (const Polygon join = outside_of_bend(a, b, gaps[i]); !join.front().empty()) {
      parts.push_back({join});
    }
  }
  for (Polygon& ground : outside_of_streets(arms, gaps))
    if (!ground.front().empty()) parts.push_back({std::move(ground)});
  if (parts.empty()) return {};
  return {whole(parts), true};
}

}  // namespace streetgen
