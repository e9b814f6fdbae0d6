#include "ring.hpp"

#include <algorithm>
#include <cmath>

#include "offset.hpp"
#include "polyline.hpp"

namespace streetgen {

namespace {

constexpr int corner_quarter = 16;
constexpr int join_quarter = 8;

void append(Ring& ring, const Line& line) { ring.insert(ring.end(), line.begin(), line.end()); }

// The kerb from abscissa u to v, its end at u or v replaced by a given point.
Line kerb(const Arm& arm, double u, double v, int side) {
  return kerb_line(arm.line, u, v, arm.half_start, arm.half_end, side);
}

void append_corner(Ring& ring, const CornerArc& corner) {
  ring.push_back(corner.arc.start);
  if (corner.radius > 0)
    append_arc(ring, corner.centre, corner.arc.start, corner.arc.end,
               cross(corner.arc.middle - corner.arc.start, corner.arc.end - corner.arc.middle) > 0,
               corner_quarter);
  ring.push_back(corner.arc.end);
}

// Where the circle touches the round end of an arm behind the node: along that end.
void append_round_end(Ring& ring, const Point& node, const Point& from, const Point& to) {
  ring.push_back(from);
  if (distance(from, to) > 1e-6) append_arc(ring, node, from, to, true, join_quarter);
}

void append_gap(Ring& ring, const Arm& a, const Arm& b, const Gap& gap) {
  if (gap.meets) {
    Line in = kerb(a, a.limit, gap.corner.abscissa_a, +1);
    if (in.size() > 1) ring.insert(ring.end(), in.begin() + 1, in.end() - 1);
    const Point node = planar(a.line.front());
    if (gap.corner.abscissa_a == 0)
      append_round_end(ring, node, kerb(a, 0, 0, +1)[0], gap.corner.arc.start);
    append_corner(ring, gap.corner);
    if (gap.corner.abscissa_b == 0)
      append_round_end(ring, node, gap.corner.arc.end, kerb(b, 0, 0, -1)[0]);
    Line out = kerb(b, gap.corner.abscissa_b, b.limit, -1);
    if (out.size() > 1) ring.insert(ring.end(), out.begin() + 1, out.end() - 1);
    return;
  }
  const Line in = kerb(a, a.limit, 0, +1), out = kerb(b, 0, b.limit, -1);
  if (in.size() > 1) ring.insert(ring.end(), in.begin() + 1, in.end());
  if (distance(in.back(), out.front()) > 0)
    append_arc(ring, planar(a.line.front()), in.back(), out.front(), true, join_quarter);
  if (out.size() > 1) ring.insert(ring.end(), out.begin(), out.end() - 1);
}

Polygon fan(const Point& centre, const Point& from, const Point& to) {
  Ring ring{centre, from};
  append_arc(ring, centre, from, to, true, join_quarter);
  ring.push_back(to);
  return {closed(std::move(ring))};
}

// Between the two axes and the arc: the ground that the corner adds.
Polygon fillet(const Arm& a, const Arm& b, const Gap& gap) {
  Ring ring = planar(substring(a.line, 0, gap.corner.abscissa_a));
  append_corner(ring, gap.corner);
  append(ring, planar(substring(b.line, gap.corner.abscissa_b, 0)));
  return {closed(std::move(ring))};
}

MultiPolygon pieces(const Line& line, const std::vector<double>& left,
                    const std::vector<double>& right) {
  MultiPolygon out;
  const auto add = [&](Polygon polygon) {
    if (!polygon.front().empty()) out.push_back(std::move(polygon));
  };
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point direction = unit(line[i] - line[i - 1]), across = left_normal(direction);
    add({closed({line[i - 1] + across * left[i - 1], line[i - 1] - across * right[i - 1],
                 line[i] - across * right[i], line[i] + across * left[i]})});
    if (i + 1 == line.size()) break;
    const Point next = left_normal(unit(line[i + 1] - line[i]));
    const double turn = cross(across, next);
    if (std::abs(turn) < 1e-12 && dot(across, next) > 0) continue;
    if (turn > 0)
      add(fan(line[i], line[i] - across * right[i], line[i] - next * right[i]));
    else
      add(fan(line[i], line[i] + next * left[i], line[i] + across * left[i]));
  }
  return out;
}

Polygon disc(const Point& centre, double radius) {
  Ring ring;
  for (int i = 0; i <= 4 * join_quarter; ++i) {
    const double angle = 2 * M_PI * (i % (4 * join_quarter)) / (4 * join_quarter);
    ring.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle), 0});
  }
  return {ring};
}

MultiPolygon arm_pieces(const Arm& arm, double start, double end) {
  const Line part = distinct(planar(substring(arm.line, start, end)));
  std::vector<double> half(part.size());
  double abscissa = start;
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (i > 0) abscissa += distance(part[i - 1], part[i]);
    half[i] = half_at(arm, abscissa);
  }
  return pieces(part, half, half);
}

bool simple(Geos& geos, const Ring& ring) {
  return ring.size() >= 4 && signed_area(ring) > 0 && geos.valid(geos.polygon({ring}).get());
}

}  // namespace

double half_at(const Arm& arm, double abscissa) {
  if (arm.half_start == arm.half_end) return arm.half_start;
  const double total = length(arm.line);
  return arm.half_start + (arm.half_end - arm.half_start) * std::clamp(abscissa / total, 0.0, 1.0);
}

Line border_across(const Arm& arm, double abscissa) {
  const Point foot = planar(place_at(arm.line, abscissa).point);
  const Point across = left_normal(local_direction(arm.line, abscissa)) * half_at(arm, abscissa);
  return {foot + across, foot - across};
}

Ring closed(Ring ring) {
  Ring out;
  for (const Point& p : ring)
    if (out.empty() || distance(out.back(), p) > 1e-9) out.push_back(p);
  while (out.size() > 1 && distance(out.back(), out.front()) <= 1e-9) out.pop_back();
  if (out.size() < 3) return {};
  out.push_back(out.front());
  return out;
}

Built build_section(Geos& geos, const Arm& arm, double start, double end, const Line& start_border,
                    const Line& end_border) {
  Ring ring{start_border[1]};
  const Line right = kerb(arm, start, end, -1), left = kerb(arm, end, start, +1);
  if (right.size() > 1) ring.insert(ring.end(), right.begin() + 1, right.end() - 1);
  ring.push_back(end_border[1]);
  ring.push_back(end_border[0]);
  if (left.size() > 1) ring.insert(ring.end(), left.begin() + 1, left.end() - 1);
  ring.push_back(start_border[0]);
  ring = closed(std::move(ring));
  if (simple(geos, ring)) return {{{ring}}, false};
  return {geos.polygons(geos.unite({arm_pieces(arm, start, end)}).get()), true};
}

Ring intersection_outline(const std::vector<Arm>& arms, const std::vector<Gap>& gaps) {
  Ring ring;
  for (std::size_t i = 0; i < arms.size(); ++i) {
    ring.push_back(arms[i].border[1]);
    ring.push_back(arms[i].border[0]);
    append_gap(ring, arms[i], arms[(i + 1) % arms.size()], gaps[i]);
  }
  return closed(std::move(ring));
}

Built build_intersection(Geos& geos, const std::vector<Arm>& arms, const std::vector<Gap>& gaps) {
  const Ring ring = intersection_outline(arms, gaps);
  if (simple(geos, ring)) return {{{ring}}, false};
  std::vector<MultiPolygon> parts;
  for (std::size_t i = 0; i < arms.size(); ++i) {
    const Arm &a = arms[i], &b = arms[(i + 1) % arms.size()];
    if (a.limit > 0) parts.push_back(arm_pieces(a, 0, a.limit));
    if (gaps[i].meets) {
      const Polygon ground = fillet(a, b, gaps[i]);
      if (!ground.front().empty()) parts.push_back({ground});
    } else {
      const Point left = kerb(a, 0, 0, +1).front(), right = kerb(b, 0, 0, -1).front();
      const Point node = planar(a.line.front());
      if (cross(left - node, right - node) > 0 || dot(left - node, right - node) < 0) {
        const Polygon join = fan(node, left, right);
        if (!join.front().empty()) parts.push_back({join});
      }
    }
  }
  if (parts.empty()) return {};
  return {geos.polygons(geos.unite(parts).get()), true};
}

MultiPolygon build_buffer(Geos& geos, const Line& line, const std::vector<double>& left,
                          const std::vector<double>& right, bool round_ends) {
  MultiPolygon all = pieces(line, left, right);
  if (round_ends) {
    all.push_back(disc(line.front(), std::max(left.front(), right.front())));
    all.push_back(disc(line.back(), std::max(left.back(), right.back())));
  }
  return geos.polygons(geos.unite({all}).get());
}

}  // namespace streetgen
