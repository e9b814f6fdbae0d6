#include "roadway/street_surface.hpp"

#include <utility>

#include "geometry/fill_holes.hpp"
#include "layout/width_transition.hpp"
#include "roadway/fit_to_area.hpp"
#include "roadway/near_limits.hpp"
#include "roadway/round_kink.hpp"

namespace streetgen {

namespace {

Surface surface_of(Built built) {
  return {std::move(built.surface), built.by_union ? Method::robust_fallback : Method::hypothesis};
}

Surface transition_of(Geos& geos, const Junction& junction, const std::vector<Arm>& arms) {
  const int from = junction.transition_from();
  return {build_transition(geos, arms[from], arms[1 - from], junction.transition->kind),
          Method::transition};
}

// The border lines of the arms, the corners that are wanted sharp, and the parts of paved ground.
std::vector<Line> unrounded(const std::vector<Arm>& arms, const std::vector<Gap>& gaps) {
  std::vector<Line> lines;
  for (const Arm& arm : arms) lines.push_back(arm.border);
  for (const Gap& gap : gaps) {
    if (gap.meets && gap.sharp) lines.push_back({gap.corner.centre, gap.corner.centre});
    if (gap.meets && !gap.beyond.empty()) lines.push_back(gap.beyond.front());
  }
  return lines;
}

// Holes filled and kinks rounded, clear of `borders`.
void finish(Geos& geos, const StreetSettings& settings, const std::vector<Line>& borders,
            MultiPolygon& ground) {
  fill_holes(ground, settings.least_island());
  round_kinks(geos, ground, settings.kerb_radius_minimal, borders);
}

}  // namespace

Surface section_of(Geos& geos, const Layout& layout, int e) {
  if (limits_crossed(layout.streets, e)) return {{}, Method::crossed_limits};
  const SectionLimit &start = layout.streets.limits[2 * e], &end = layout.streets.limits[2 * e + 1];
  const SectionPartings partings = partings_of(layout, e);
  Surface surface = surface_of(
      build_section(geos, layout.arms[2 * e], layout.streets.roadways[e].profile, start.abscissa,
                    end.abscissa, start.border_line, end.border_line, partings));
  const Edge& edge = layout.streets.network.edges[e];
  if (layout.settings.round_dead_ends)
    for (const bool at_start : {true, false})
      if (layout.junctions[at_start ? edge.from_node : edge.to_node].dead_end())
        surface.ground = with_round_end(geos, surface.ground, layout.arm({e, at_start}));
  std::vector<Line> borders{start.border_line, end.border_line};
  for (Parting& parting : partings.all()) borders.push_back(std::move(parting.line));
  finish(geos, layout.settings, borders, surface.ground);
  surface.ground = fit_section(geos, layout, e, std::move(surface.ground));
  return surface;
}

Surface intersection_of(Geos& geos, const Layout& layout, int node) {
  const Junction& junction = layout.junctions[node];
  if (junction.dead_end() || junction.straight) return {};
  const std::vector<Arm> arms = layout.arms_of(node);
  Surface surface = junction.transition ? transition_of(geos, junction, arms)
                                        : surface_of(build_intersection(geos, arms, junction.gaps));
  finish(geos, layout.settings, unrounded(arms, junction.gaps), surface.ground);
  surface.ground = fit_intersection(geos, layout, node, std::move(surface.ground));
  return surface;
}

}  // namespace streetgen
