// Surfaces of a road model as triangles with heights.
#pragma once

#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

struct MeshedSurface {
  MultiPolygon surface;
  int level = 0;
  // Whether its triangles are asked for. Others only give the vertices that neighbours share.
  bool wanted = true;
};

// An axis that says how high the roadway of its level lies.
struct HeightAxis {
  Line line;
  int level = 0;
};

// The triangles of each surface, in their order; none of a surface that is not wanted.
//
// Triangles tile their surface. Surfaces of one level meet in common vertices: vertices within five
// micrometres of each other are one, and a side gets a vertex that a neighbour has on it.
//
// The height of a vertex is that of the nearest place of the axes of its level, 0 where there are
// no axes. The mesh leaves the height of an axis on its surfaces by at most the tolerance, metres,
// as it does on borders, but for steps of the height, as between the axes of a junction. For that
// axes are edges of triangles where they climb, and a section is cut across where they bend.
// Each side of a border is divided by itself, so neighbours agree.
//
// GEOS makes the triangles: constrained Delaunay, without a vertex of its own.
std::vector<std::vector<Triangle>> mesh_surfaces(const std::vector<MeshedSurface>& surfaces,
                                                 const std::vector<HeightAxis>& axes,
                                                 double tolerance);

}  // namespace streetgen
