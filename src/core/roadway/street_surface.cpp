#include "roadway/street_surface.hpp"

#include "geometry/fill_holes.hpp"
#include "roadway/width_transition.hpp"

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

}  // namespace

Surface section_of(Geos& geos, const Layout& layout, int e) {
  if (limits_crossed(layout.streets, e)) return {{}, Method::crossed_limits};
  const SectionLimit &start = layout.streets.limits[2 * e], &end = layout.streets.limits[2 * e + 1];
  Surface surface = surface_of(build_section(geos, layout.arms[2 * e], start.abscissa, end.abscissa,
                                             start.border_line, end.border_line));
  const Edge& edge = layout.streets.network.edges[e];
  if (layout.settings.round_dead_ends)
    for (const bool at_start : {true, false})
      if (layout.junctions[at_start ? edge.from_node : edge.to_node].dead_end())
        surface.ground = with_round_end(geos, surface.ground, layout.arm({e, at_start}));
  fill_holes(surface.ground, layout.settings.max_hole_area);
  return surface;
}

Surface intersection_of(Geos& geos, const Layout& layout, int node) {
  const Junction& junction = layout.junctions[node];
  if (junction.dead_end() || junction.straight) return {};
  const std::vector<Arm> arms = layout.arms_of(node);
  Surface surface = junction.transition ? transition_of(geos, junction, arms)
                                        : surface_of(build_intersection(geos, arms, junction.gaps));
  fill_holes(surface.ground, layout.settings.max_hole_area);
  return surface;
}

}  // namespace streetgen
