#include "roadway/near_limits.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"
#include "geometry/ring_simplicity.hpp"
#include "geometry/tolerance.hpp"
#include "roadway/street_face.hpp"

namespace streetgen {

namespace {

constexpr double distant = 1.2;  // of the distance of limits: nearer ones stay
constexpr double soon = 0.6;     // of the distance of limits: kerbs that cross nearer part soon
const double slowly = std::cos(M_PI / 4 + same_angle);  // of streets where their kerbs cross
constexpr double most_of_way = 0.9;  // from the node to the crossing of the kerbs

bool keeps_width(const Arm& arm) { return arm.half_start == arm.half_end; }

std::size_t place_of(const Junction& junction, const EdgeEnd& end) {
  std::size_t i = 0;
  while (slot(junction.ends[i]) != slot(end)) ++i;
  return i;
}

// The gap on a side of an edge's end, seen from the node; none at a dead end.
const Gap* gap_beside(const Layout& layout, const EdgeEnd& end, int side) {
  const Junction& junction = layout.junction_of(end);
  if (junction.dead_end()) return nullptr;
  const std::size_t i = place_of(junction, end), count = junction.ends.size();
  return &junction.gaps[side > 0 ? i : (i + count - 1) % count];
}

// Whether a parting lies beside the axis of its arm, from the border line on.
bool beside(const Arm& arm, const Parting& parting, int side) {
  const Point& from = parting.line.front();
  const Point foot = planar(position_at(arm.line, arm.limit).point);
  const Point& kerb = arm.border[side > 0 ? 0 : 1];
  if (distance(from, kerb) >= distance(foot, kerb)) return false;
  const Ring ground = parting.ground(arm.line, arm.limit);
  return ground.size() > 3 && side * signed_area(ground) > 0 && simple({{ground}}).value_or(false);
}

bool parts(const Layout& layout, const Junction& junction, std::size_t i) {
  const EdgeEnd &a = junction.ends[i], &b = junction.next(i);
  const Gap& gap = junction.gaps[i];
  const ArcEnds ends{kerb_room(layout, a, +1), kerb_room(layout, b, -1)};
  return !limits_crossed(layout.streets, a.edge) && !limits_crossed(layout.streets, b.edge) &&
         ends.hold(gap.corner) && !gap.parting.empty() &&
         beside(layout.arm(a), parting_of(gap, true), +1) &&
         beside(layout.arm(b), parting_of(gap, false), -1);
}

// Gives a corner the arc of the largest radius that ends within bounds, where that of the end of a
// narrow median does.
void shrink_arc(Layout& layout, const CornerPlace& at, const ArcEnds& ends) {
  constexpr double precision = 1e-7;
  Junction& junction = layout.junctions[at.node];
  const Arm &a = layout.arm(junction.ends[at.gap]), &b = layout.arm(junction.next(at.gap));
  CornerArc& corner = junction.gaps[at.gap].corner;
  const auto within = [&](double radius) {
    auto arc = corner_arc(a.line, b.line, 2 * a.start_to(+1), 2 * b.start_to(-1), radius);
    if (arc && !ends.hold(*arc)) arc.reset();
    return arc;
  };
  const double least = layout.settings.median_width_minimal / 2;
  if (corner.radius <= least) return;
  auto found = within(least);
  if (!found) return;
  for (double low = least, high = corner.radius; high - low > precision;) {
    const double middle = (low + high) / 2;
    const auto tried = within(middle);
    (tried ? low : high) = middle;
    if (tried) found = tried;
  }
  corner = *found;
  Corner& row = corner_row(layout, at);
  row.radius = found->radius;
  row.centre = found->centre;
  row.arc = found->arc;
  if (row.method == Method::hypothesis) row.method = Method::radius_reduced;
}

// Border lines meet farther out where another corner moved one limit outwards.  Gives the edge
// whose limit follows; none where it is there, or the kerbs cross before.
std::optional<int> meet_farther_out(const Layout& layout, const Junction& junction, std::size_t i,
                                    std::vector<double>& wanted) {
  constexpr double least_step = 0.01;  // metres
  const EdgeEnd &end_a = junction.ends[i], &end_b = junction.next(i);
  const Arm &a = layout.arm(end_a), &b = layout.arm(end_b);
  const CornerArc& crossing = *junction.gaps[i].crossing;
  const double share_a = a.limit / crossing.abscissa_a, share_b = b.limit / crossing.abscissa_b;
  if (std::max(share_a, share_b) > most_of_way) return std::nullopt;
  const EdgeEnd& behind = share_a < share_b ? end_a : end_b;
  const double limit = nearest_abscissa(place_between(a, b, crossing, std::max(share_a, share_b)),
                                        layout.arm(behind).line);
  double& own = wanted[slot(behind)];
  if (limit < std::max(own, layout.arm(behind).limit) + least_step) return std::nullopt;
  own = limit;
  return behind.edge;
}

}  // namespace

void bring_limits_near(const Arm& a, const Arm& b, double limit_distance, SolvedCorner& corner) {
  if (std::max(corner.limit_a, corner.limit_b) <= distant * limit_distance) return;
  const CornerArc& arc = corner.gap.corner;
  if (!corner.gap.meets || !corner.gap.beyond.empty() || !keeps_width(a) || !keeps_width(b)) return;
  const double half_a = a.start_to(+1), half_b = b.start_to(-1);
  if (half_a <= 0 || half_b <= 0) return;
  const auto crossing = corner_arc(a.line, b.line, 2 * half_a, 2 * half_b, 0);
  if (!crossing || crossing->abscissa_a > arc.abscissa_a || crossing->abscissa_b > arc.abscissa_b)
    return;
  const double way = std::max(crossing->abscissa_a, crossing->abscissa_b);
  const Point along_a = position_at(a.line, crossing->abscissa_a).direction,
              along_b = position_at(b.line, crossing->abscissa_b).direction;
  if (way < soon * limit_distance || dot(along_a, along_b) < slowly) return;
  const Point limits = place_between(a, b, *crossing, std::min(limit_distance / way, most_of_way));
  const double limit_a = nearest_abscissa(limits, a.line),
               limit_b = nearest_abscissa(limits, b.line);
  if (limit_a >= crossing->abscissa_a || limit_b >= crossing->abscissa_b) return;
  corner.limit_a = limit_a;
  corner.limit_b = limit_b;
  corner.gap.crossing = crossing;
}

std::vector<int> part_sections(Layout& layout, const std::vector<bool>& settled,
                               std::vector<double>& wanted) {
  std::vector<int> moved;
  for (int n = 0; n < static_cast<int>(layout.junctions.size()); ++n) {
    Junction& junction = layout.junctions[n];
    for (std::size_t i = 0; i < junction.gaps.size(); ++i) {
      Gap& gap = junction.gaps[i];
      if (!gap.crossing) continue;
      const EdgeEnd &a = junction.ends[i], &b = junction.next(i);
      if (!settled[a.edge] && !settled[b.edge]) continue;
      const ArcEnds own{kerb_room(layout, a, +1), kerb_room(layout, b, -1)};
      if (!own.hold(gap.corner)) shrink_arc(layout, {n, i}, own);
      gap.parting = parting_line(layout.arm(a), layout.arm(b), gap);
      if (parts(layout, junction, i)) continue;
      if (const auto edge = meet_farther_out(layout, junction, i, wanted)) {
        moved.push_back(*edge);
        continue;
      }
      gap.crossing.reset();
      gap.parting.clear();
      const double near = distant * layout.settings.limit_distance - coordinate_margin;
      shrink_arc(layout, {n, i}, {near, near});
      wanted[slot(a)] = std::max(wanted[slot(a)], gap.corner.abscissa_a);
      wanted[slot(b)] = std::max(wanted[slot(b)], gap.corner.abscissa_b);
      moved.insert(moved.end(), {a.edge, b.edge});
    }
  }
  std::sort(moved.begin(), moved.end());
  moved.erase(std::unique(moved.begin(), moved.end()), moved.end());
  return moved;
}

void end_borders_on_partings(Layout& layout) {
  for (const Junction& junction : layout.junctions)
    for (std::size_t i = 0; i < junction.gaps.size(); ++i) {
      const Gap& gap = junction.gaps[i];
      if (gap.parting.empty()) continue;
      const EdgeEnd &a = junction.ends[i], &b = junction.next(i);
      layout.arm(a).border[0] = layout.arm(b).border[1] = gap.parting.front();
      const auto share = [&](const EdgeEnd& end, double arc) {
        double& longest = layout.streets.limits[slot(end)].shared;
        longest = std::max(longest, arc - layout.arm(end).limit);
      };
      share(a, gap.corner.abscissa_a);
      share(b, gap.corner.abscissa_b);
    }
}

double kerb_room(const Layout& layout, const EdgeEnd& end, int side) {
  const EdgeEnd other{end.edge, !end.at_start};
  double taken = layout.arm(other).limit;
  const Gap* gap = gap_beside(layout, other, -side);
  if (gap != nullptr && gap->meets)
    taken = std::max(taken, side > 0 ? gap->corner.abscissa_b : gap->corner.abscissa_a);
  return std::max(0.0, length(layout.arm(end).line) - taken);
}

SectionPartings partings_of(const Layout& layout, int edge) {
  SectionPartings partings;
  for (const bool at_start : {true, false}) {
    const EdgeEnd end{edge, at_start};
    if (layout.streets.limits[slot(end)].shared <= 0) continue;
    for (const int side : {+1, -1}) {
      const Gap* gap = gap_beside(layout, end, side);
      if (gap->parting.empty()) continue;
      Parting parting = parting_of(*gap, side > 0);
      if (at_start) {
        partings.on(side).at_start = std::move(parting);
      } else {
        parting.until = length(layout.arm(end).line) - parting.until;
        partings.on(-side).at_end = std::move(parting);
      }
    }
  }
  return partings;
}

}  // namespace streetgen
