// Sections and intersections end where the areas do that were surveyed as roadway.
#pragma once

#include "geometry/geos.hpp"
#include "layout/layout.hpp"
#include "streetgen/geometry.hpp"

namespace streetgen {

// The ground of the section of an edge by the area of its axis; as it is where the axis has none,
// or lies outside of it.
MultiPolygon fit_section(Geos& geos, const Layout& layout, int edge, MultiPolygon ground);

// The same of the intersection of a node, by the areas of its axes.
MultiPolygon fit_intersection(Geos& geos, const Layout& layout, int node, MultiPolygon ground);

}  // namespace streetgen
