// The surface of one edge and of one node, as the axes about it make it.
#pragma once

#include "geometry/geos.hpp"
#include "layout/layout.hpp"

namespace streetgen {

struct Surface {
  MultiPolygon ground;
  Method method = Method::hypothesis;
};

Surface section_of(Geos& geos, const Layout& layout, int edge);
// None at a dead end.
Surface intersection_of(Geos& geos, const Layout& layout, int node);

}  // namespace streetgen
