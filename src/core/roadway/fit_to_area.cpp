#include "roadway/fit_to_area.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry/arrangement.hpp"
#include "geometry/box.hpp"
#include "geometry/crumb.hpp"
#include "geometry/fill_holes.hpp"
#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "geometry/tolerance.hpp"
#include "layout/surface_ring.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/kerbs_by_area.hpp"

namespace streetgen {

namespace {

constexpr double least_in_area = 0.01;  // metres along an axis in or out of an area

// The ground along stretches of axes, of those that have areas also somewhat beyond their kerbs.
struct Strips {
  std::vector<MultiPolygon> within;   // where axes lie in their areas
  std::vector<MultiPolygon> without;  // where they lie outside
  std::vector<MultiPolygon> plain;    // outside, between the kerbs; of axes without areas all
};

bool any_holds(const std::vector<MultiPolygon>& grounds, const Point& place) {
  return std::any_of(grounds.begin(), grounds.end(),
                     [&](const MultiPolygon& ground) { return inside(place, ground); });
}

MultiPolygon strip(Geos& geos, Arm arm, double from, double to, double beyond) {
  arm.half_start += beyond;
  arm.half_end += beyond;
  return build_section(geos, arm, {}, from, to, border_across(arm, from), border_across(arm, to),
                       {})
      .surface;
}

// A stretch of an axis, metres along it.
struct AreaStretch {
  double begin = 0, end = 0;
  bool within = false;  // in the area of the axis
};

// The abscissas where a line comes into an area or leaves it, and its end.
std::vector<double> borders_along(const Line& line, const MultiPolygon& area) {
  std::vector<double> borders;
  double abscissa = 0;
  for (std::size_t k = 1; k < line.size(); ++k) {
    const Box box = box_of(line[k - 1], line[k]);
    for (const Polygon& polygon : area)
      for (const Ring& ring : polygon)
        for (std::size_t i = 1; i < ring.size(); ++i) {
          if (!box.meets(box_of(ring[i - 1], ring[i]))) continue;
          const auto met = crossing(line[k - 1], line[k], ring[i - 1], ring[i]);
          if (met) borders.push_back(abscissa + distance(line[k - 1], *met));
        }
    abscissa += distance(line[k - 1], line[k]);
  }
  borders.push_back(abscissa);
  std::sort(borders.begin(), borders.end());
  return borders;
}

// What lies between areas that touch is no stretch of its own.
std::vector<AreaStretch> stretches_of(const Line& line, const MultiPolygon& area) {
  std::vector<AreaStretch> stretches;
  double begin = 0;
  for (const double end : borders_along(line, area)) {
    const bool within = inside(planar(position_at(line, (begin + end) / 2).point), area);
    if (!stretches.empty() && (end - begin < area_touching || stretches.back().within == within))
      stretches.back().end = end;
    else
      stretches.push_back({begin, end, within});
    begin = end;
  }
  return stretches;
}

// Those along an arm, between two abscissas. An area may end askew, so what the axis has outside
// goes on for half of its width.
void append_strips(Geos& geos, const Arm& arm, const MultiPolygon& area, double from, double to,
                   Strips& strips) {
  const auto add = [&](std::vector<MultiPolygon>& some, double begin, double end, double beyond) {
    begin = std::max(begin, from);
    end = std::min(end, to);
    if (end - begin >= least_in_area) some.push_back(strip(geos, arm, begin, end, beyond));
  };
  if (area.empty()) return add(strips.plain, from, to, 0);
  const double half = std::max(arm.half_start, arm.half_end);
  for (const auto& [begin, end, within] : stretches_of(arm.line, area)) {
    if (within) {
      add(strips.within, begin, end, area_beyond_kerb);
      continue;
    }
    add(strips.without, begin, end, area_beyond_kerb);
    add(strips.plain, begin - half, end + half, 0);
  }
}

// The parts of an area near other ground.
void append_near(const MultiPolygon& area, const Box& box, MultiPolygon& near) {
  for (const Polygon& polygon : area)
    if (box_of(MultiPolygon{polygon}).meets(box)) near.push_back(polygon);
}

// The parts that hold a place of what was there, of faces that are kept.
class Fit {
 public:
  Fit(const MultiPolygon& ground, const Strips& strips, const std::vector<MultiPolygon>& others,
      const std::vector<const MultiPolygon*>& areas)
      : ground_(ground), strips_(strips), others_(others) {
    Box box = box_of(ground);
    for (const MultiPolygon& strip : strips.within) box = box.joined_with(box_of(strip));
    for (const MultiPolygon* area : areas) append_near(*area, box, area_);
  }

  MultiPolygon surface(Geos& geos) const {
    std::vector<LineView> lines;
    const auto add = [&](const MultiPolygon& surface) {
      for (const Polygon& polygon : surface)
        lines.insert(lines.end(), polygon.begin(), polygon.end());
    };
    add(ground_);
    add(area_);
    for (const auto* grounds : {&strips_.within, &strips_.without, &strips_.plain, &others_})
      std::for_each(grounds->begin(), grounds->end(), add);
    const Arrangement faces(lines);
    std::vector<bool> kept;
    std::vector<Point> had;
    for (const Point& place : faces.places()) {
      poll_cancel();
      const bool own = inside(place, ground_);
      kept.push_back(keeps(place, own));
      if (kept.back() && own) had.push_back(place);
    }
    MultiPolygon joined = faces.joined(kept);
    if (!geos.valid(joined)) joined = faces.joined(kept, Arrangement::Vertices::on_grid);
    joined.erase(std::remove_if(joined.begin(), joined.end(),
                                [&](const Polygon& part) {
                                  return std::none_of(had.begin(), had.end(), [&](const Point& p) {
                                    return inside(p, part);
                                  });
                                }),
                 joined.end());
    return without_crumbs(std::move(joined));
  }

 private:
  bool keeps(const Point& place, bool own) const {
    const bool beside = any_holds(strips_.within, place);
    if (own && (any_holds(strips_.plain, place) || (!beside && any_holds(strips_.without, place))))
      return true;
    if (inside_area(place)) return own || (beside && !any_holds(others_, place));
    return own && between_areas(place);
  }

  // Axes that meet have parts of their areas in common.
  bool inside_area(const Point& place) const {
    return std::any_of(area_.begin(), area_.end(),
                       [&](const Polygon& polygon) { return inside(place, polygon); });
  }

  // Whether areas that touch lie on both sides.
  bool between_areas(const Point& place) const {
    constexpr int directions = 4;
    for (int k = 0; k < directions; ++k) {
      const double angle = M_PI * k / directions;
      const Point across = Point{std::cos(angle), std::sin(angle)} * (area_touching / 2);
      if (inside_area(place + across) && inside_area(place - across)) return true;
    }
    return false;
  }

  const MultiPolygon& ground_;
  const Strips& strips_;
  const std::vector<MultiPolygon>& others_;
  MultiPolygon area_;
};

MultiPolygon fitted(Geos& geos, const Layout& layout, const MultiPolygon& ground,
                    const Strips& strips, const std::vector<MultiPolygon>& others,
                    const std::vector<const MultiPolygon*>& areas) {
  MultiPolygon fit = Fit(ground, strips, others, areas).surface(geos);
  fill_holes(fit, layout.settings.least_island());
  return fit;
}

}  // namespace

MultiPolygon fit_section(Geos& geos, const Layout& layout, int e, MultiPolygon ground) {
  const MultiPolygon& area = layout.axis_of(e).area;
  if (area.empty() || ground.empty()) return ground;
  Strips strips;
  append_strips(geos, layout.arms[2 * e], area, layout.streets.limits[2 * e].abscissa,
                layout.streets.limits[2 * e + 1].abscissa, strips);
  if (strips.within.empty()) return ground;
  return fitted(geos, layout, ground, strips, {}, {&area});
}

MultiPolygon fit_intersection(Geos& geos, const Layout& layout, int node, MultiPolygon ground) {
  if (ground.empty()) return ground;
  Strips strips;
  std::vector<MultiPolygon> sections;
  std::vector<const MultiPolygon*> areas;
  for (const EdgeEnd& end : layout.junctions[node].ends) {
    const MultiPolygon& area = layout.axis_of(end.edge).area;
    const Arm& arm = layout.arm(end);
    append_strips(geos, arm, area, 0, arm.limit, strips);
    if (area.empty()) continue;
    areas.push_back(&area);
    const double beyond =
        std::min(arm.limit + 2 * (arm.reach() + area_beyond_kerb), length(arm.line));
    if (beyond - arm.limit >= least_in_area)
      sections.push_back(strip(geos, arm, arm.limit, beyond, area_beyond_kerb));
  }
  if (strips.within.empty()) return ground;
  return fitted(geos, layout, ground, strips, sections, areas);
}

}  // namespace streetgen
