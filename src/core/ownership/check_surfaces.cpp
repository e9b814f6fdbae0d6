#include "ownership/check_surfaces.hpp"

#include "geometry/closed_ring.hpp"
#include "support/invariant.hpp"

namespace streetgen {

void check_surfaces(const Streets& streets) {
  if (!invariants_are_checked) return;
  for (std::size_t s = 0; s < streets.sections.size(); ++s) {
    const Section& section = streets.sections[s];
    must_hold(streets.affected_edges.at(section.edge), "a section is affected", s);
    must_hold(has_closed_rings(section.surface), "rings of sections are closed", s);
  }
  for (std::size_t i = 0; i < streets.intersections.size(); ++i) {
    const Intersection& intersection = streets.intersections[i];
    must_hold(streets.affected_nodes.at(intersection.node), "an intersection is affected", i);
    must_hold(has_closed_rings(intersection.surface), "rings of intersections are closed", i);
  }
}

}  // namespace streetgen
