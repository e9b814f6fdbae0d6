// Surfaces of a road model as triangles with heights.
#pragma once

#include <array>
#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

struct MeshedSurface {
  MultiPolygon surface;
  int level = 0;
  // Texture coordinates are counted along this line, in the plane: two points or more.
  Line line;
  // Metres above the height of the place: a sidewalk lies as high as its kerb.
  double raised = 0;
  // Whether its triangles are asked for. Others only give the vertices that neighbours share.
  bool wanted = true;
};

// An axis that says how high the roadway of its level lies.
struct HeightAxis {
  Line line;
  int level = 0;
  double half_width = 0;  // of its roadway, metres
};

struct SurfaceMesh {
  std::vector<Triangle> triangles;
  // Three of each triangle, those of its corners, in their order.
  // Unit vectors. On the ground that of the nearest axis, level across it; the mean where it bends.
  std::vector<Point> normals;
  // Metres along the line of the surface and to its left; the line goes straight on at its ends.
  // On a kerb the second one is metres above its foot.
  std::vector<std::array<double, 2>> texture;
};

struct GroundMesh {
  SurfaceMesh ground;
  // Upright, from lower neighbours to a raised surface, seen from the lower ones.
  SurfaceMesh kerb;
};

// The mesh of each surface, in their order; empty of a surface that is not wanted.
//
// Triangles tile their surface. Surfaces of one level meet in common vertices: vertices within five
// micrometres of each other are one, and a side gets a vertex that a neighbour has on it. Where a
// raised surface meets a lower one, its kerb closes the step: both meshes have the kerb's vertices.
//
// The height of a vertex is that of the axis of its level in whose roadway it lies, at the nearest
// place, of several the nearest one's; beyond all roadways that of the nearest roadway's; 0 where
// there are no axes; and what its surface is raised. The mesh leaves the height of an axis on its
// surfaces by at most the tolerance, metres, as it does on borders, but for steps of the height, as
// between the axes of a junction. For that axes are edges of triangles where they climb, and a
// section is cut across where they bend. Each side of a border is divided by itself, so neighbours
// agree.
//
// GEOS makes the triangles: constrained Delaunay, without a vertex of its own.
std::vector<GroundMesh> mesh_surfaces(const std::vector<MeshedSurface>& surfaces,
                                      const std::vector<HeightAxis>& axes, double tolerance);

}  // namespace streetgen
