#include "layout/parting.hpp"

#include <algorithm>
#include <set>

#include "geometry/closed_ring.hpp"
#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "layout/drawn_arc.hpp"

namespace streetgen {

namespace {

// Where the line goes on in another direction between two abscissas, as shares of the way.
void add_bends(const Line& line, double from, double to, std::set<double>& shares) {
  double abscissa = 0;
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    abscissa += distance(line[i - 1], line[i]);
    if (abscissa > from + coordinate_margin && abscissa < to - coordinate_margin)
      shares.insert((abscissa - from) / (to - from));
  }
}

// As far from both axes as each is wide, at abscissas of these.
Point between(const Arm& a, const Arm& b, double on_a, double on_b) {
  const Point from = planar(position_at(a.line, on_a).point),
              to = planar(position_at(b.line, on_b).point);
  return from + (to - from) * (a.start_to(+1) / (a.start_to(+1) + b.start_to(-1)));
}

// Border lines of parallel streets may be one line.
std::optional<Point> crossing_of_borders(const Arm& a, const Arm& b) {
  const auto found = crossing(a.border[0], a.border[1], b.border[0], b.border[1]);
  const Point place = between(a, b, a.limit, b.limit);
  const auto on = [&](const Line& border) {
    return distance_to_segment(place, border[0], border[1]) < rounding;
  };
  return found || !on(a.border) || !on(b.border) ? found : std::optional(place);
}

// With a vertex in its middle, the same one from either end.
Line arc_with_middle(const CornerArc& corner) {
  Line arc = drawn_arc(corner);
  const std::size_t half = arc.size() / 2;
  if (arc.size() % 2 == 0) arc.insert(arc.begin() + half, (arc[half - 1] + arc[half]) * 0.5);
  return arc;
}

std::size_t middle_of(const Line& arc) { return arc.size() / 2; }

}  // namespace

Ring Parting::ground(const Line& axis, double limit) const {
  Ring ring = planar(substring(axis, limit, until));
  ring.insert(ring.end(), line.rbegin(), line.rend());
  return closed(std::move(ring));
}

std::vector<Parting> SectionPartings::all() const {
  std::vector<Parting> partings;
  for (const Side& side : {left, right})
    for (const auto& parting : {side.at_start, side.at_end})
      if (parting) partings.push_back(*parting);
  return partings;
}

Point place_between(const Arm& a, const Arm& b, const CornerArc& crossing, double share) {
  const Point end = between(a, b, crossing.abscissa_a, crossing.abscissa_b);
  return between(a, b, share * crossing.abscissa_a, share * crossing.abscissa_b) +
         (crossing.centre - end) * share;
}

Line parting_line(const Arm& a, const Arm& b, const Gap& gap) {
  const CornerArc& to = *gap.crossing;
  const auto from = crossing_of_borders(a, b);
  if (!from || a.limit > to.abscissa_a - coordinate_margin ||
      b.limit > to.abscissa_b - coordinate_margin)
    return {};
  std::set<double> shares;
  add_bends(a.line, a.limit, to.abscissa_a, shares);
  add_bends(b.line, b.limit, to.abscissa_b, shares);
  const auto at = [&](double share) {
    return between(a, b, a.limit + (to.abscissa_a - a.limit) * share,
                   b.limit + (to.abscissa_b - b.limit) * share);
  };
  const Point off_start = planar(*from) - at(0), off_end = planar(to.centre) - at(1);
  Line line{planar(*from)};
  for (const double share : shares)
    line.push_back(at(share) + off_start * (1 - share) + off_end * share);
  line.push_back(planar(to.centre));
  const Line arc = arc_with_middle(gap.corner);
  const Point& tip = arc[middle_of(arc)];
  if (distance(line.back(), tip) <= same_place) line.pop_back();
  line.push_back(tip);
  return line;
}

Parting parting_of(const Gap& gap, bool first) {
  Parting parting{gap.parting, first ? gap.corner.abscissa_a : gap.corner.abscissa_b};
  Line arc = arc_with_middle(gap.corner);
  if (first) arc = reversed(std::move(arc));
  parting.line.insert(parting.line.end(), arc.begin() + middle_of(arc) + 1, arc.end());
  return parting;
}

bool beyond_limit(const Arm& arm, const Point& place) {
  const Point &left = arm.border[0], &right = arm.border[1];
  if (cross(left - right, place - left) >= 0) return false;
  const double abscissa = nearest_abscissa(place, arm.line);
  if (abscissa >= length(arm.line) - coordinate_margin) return false;
  const LinePosition foot = position_at(arm.line, abscissa);
  const int side = cross(foot.direction, place - foot.point) > 0 ? +1 : -1;
  return distance(place, planar(foot.point)) < half_at(arm, abscissa, side) - same_place;
}

}  // namespace streetgen
