#include "roadway/check_roadway.hpp"

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "support/invariant.hpp"

namespace streetgen {

namespace {

bool touches(const Edge& edge, bool at_start, int node) {
  return (at_start ? edge.from_node : edge.to_node) == node;
}

}  // namespace

void check_corners(const Streets& streets) {
  if (!invariants_are_checked) return;
  const auto& edges = streets.network.edges;
  for (std::size_t c = 0; c < streets.corners.size(); ++c) {
    const Corner& corner = streets.corners[c];
    must_hold(touches(edges.at(corner.edge_a), corner.at_start_a, corner.node) &&
                  touches(edges.at(corner.edge_b), corner.at_start_b, corner.node),
              "a corner lies between edges of its node", c);
    must_hold(std::isfinite(corner.radius) && corner.radius >= 0, "a radius is no less than 0", c);
    if (!corner.arc) continue;
    must_hold(corner.centre.has_value(), "an arc has a centre", c);
    for (const Point& p : {corner.arc->start, corner.arc->middle, corner.arc->end})
      must_hold(std::abs(distance(*corner.centre, p) - corner.radius) <= coordinate_margin,
                "an arc lies on the circle of its corner", c);
  }
}

void check_limits(const Streets& streets) {
  if (!invariants_are_checked) return;
  must_hold(streets.limits.size() == 2 * streets.network.edges.size(), "an edge has two limits",
            streets.limits.size());
  for (std::size_t e = 0; e < streets.network.edges.size(); ++e) {
    const SectionLimit &start = streets.limits[2 * e], &end = streets.limits[2 * e + 1];
    const double size = length(streets.network.edges[e].line);
    must_hold(start.at_start && !end.at_start, "the limits of an edge are its start and its end",
              e);
    must_hold(start.abscissa >= -coordinate_margin && end.abscissa <= size + coordinate_margin &&
                  start.abscissa <= end.abscissa + same_place,
              "the limits of an edge lie on it in their order", e);
  }
}

}  // namespace streetgen
