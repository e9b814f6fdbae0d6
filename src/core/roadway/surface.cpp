#include "streetgen/surface.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "layout/node_corner.hpp"
#include "layout/surface_pieces.hpp"
#include "layout/surface_ring.hpp"
#include "streetgen/error.hpp"

namespace streetgen {

namespace {

Arm arm_of(const Line& axis, double width) { return {distinct(axis), width / 2, width / 2}; }

struct Around {
  std::vector<Arm> arms;
  std::vector<Gap> gaps;
};

Around around_node(const std::vector<Line>& axes, const std::vector<double>& widths,
                   const std::vector<double>& radii) {
  if (axes.size() != widths.size() || axes.size() != radii.size())
    throw Error(ErrorKind::invalid_input,
                "axes, widths and radii have " + std::to_string(axes.size()) + ", " +
                    std::to_string(widths.size()) + " and " + std::to_string(radii.size()) +
                    " elements, expected as many of each");
  std::vector<Arm> arms;
  for (std::size_t i = 0; i < axes.size(); ++i) arms.push_back(arm_of(axes[i], widths[i]));
  Around around;
  const std::vector<std::size_t> order = counter_clockwise(arms);
  for (const std::size_t i : order) around.arms.push_back(std::move(arms[i]));
  const std::size_t n = around.arms.size();
  std::vector<const Arm*> all;
  for (const Arm& arm : around.arms) all.push_back(&arm);
  for (std::size_t i = 0; i < n && n > 1; ++i) {
    const SolvedCorner solved = solve_corner(all, i, {radii[order[i]], 1e9, 0.15});
    around.gaps.push_back(solved.gap);
    widen_limits(around.arms[i], around.arms[(i + 1) % n], solved);
  }
  for (Arm& arm : around.arms) {
    arm.limit = kerb_clear_limit(arm, arm.limit);
    arm.border = border_across(arm, arm.limit);
  }
  return around;
}

}  // namespace

Line border_line(const Line& axis, double abscissa, double width, double roadway_offset) {
  Arm arm = arm_of(axis, width);
  arm.roadway_offset = roadway_offset;
  return border_across(arm, std::clamp(abscissa, 0.0, length(arm.line)));
}

MultiPolygon section_surface(const Line& axis, double width, double start_abscissa,
                             double end_abscissa) {
  const Arm arm = arm_of(axis, width);
  const double total = length(arm.line);
  const double start = std::clamp(start_abscissa, 0.0, total);
  const double end = std::clamp(end_abscissa, 0.0, total);
  if (start >= end) return {};
  Geos geos;
  return build_section(geos, arm, {}, start, end, border_across(arm, start),
                       border_across(arm, end), {})
      .surface;
}

MultiPolygon intersection_surface(const std::vector<Line>& axes, const std::vector<double>& widths,
                                  const std::vector<double>& radii) {
  const Around around = around_node(axes, widths, radii);
  if (around.gaps.empty()) return {};
  Geos geos;
  return build_intersection(geos, around.arms, around.gaps).surface;
}

CurvedRing intersection_ring(const std::vector<Line>& axes, const std::vector<double>& widths,
                             const std::vector<double>& radii) {
  const Around around = around_node(axes, widths, radii);
  if (around.gaps.empty()) return {};
  Geos geos;
  const Built built = build_intersection(geos, around.arms, around.gaps);
  if (built.by_union || built.surface.empty()) return {};
  const Ring& ring = built.surface.front().front();
  CurvedRing curved;
  const auto arc_from = [&](const Point& p) -> const CornerArc* {
    for (const Gap& gap : around.gaps)
      if (gap.meets && gap.corner.radius > 0 && distance(gap.corner.arc.start, p) <= same_place)
        return &gap.corner;
    return nullptr;
  };
  for (std::size_t i = 0; i + 1 < ring.size();) {
    std::size_t next = i + 1;
    if (const CornerArc* corner = arc_from(ring[i])) {
      while (next + 1 < ring.size() && distance(ring[next], corner->arc.end) > same_place) ++next;
      if (distance(ring[next], corner->arc.end) <= same_place && next > i + 1) {
        curved.push_back({{ring[i], corner->arc.middle, ring[next]}, true});
        i = next;
        continue;
      }
      next = i + 1;
    }
    curved.push_back({{ring[i], {}, ring[next]}, false});
    i = next;
  }
  return curved;
}

MultiPolygon variable_buffer(const Line& line, const std::vector<double>& radii, Side side,
                             Ends ends) {
  if (radii.size() != line.size())
    throw Error(ErrorKind::invalid_input, "the line has " + std::to_string(line.size()) +
                                              " vertices but " + std::to_string(radii.size()) +
                                              " radii are given");
  Line kept;
  std::vector<double> left, right;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (!kept.empty() && distance(kept.back(), line[i]) == 0) continue;
    kept.push_back(planar(line[i]));
    left.push_back(side == Side::right ? 0 : radii[i]);
    right.push_back(side == Side::left ? 0 : radii[i]);
  }
  Geos geos;
  return build_buffer(geos, kept, left, right, ends == Ends::round && side == Side::both);
}

}  // namespace streetgen
