// Meshes whose corners name places by number, as files of text list them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "streetgen/surface_mesh.hpp"

namespace streetgen {

struct IndexedMesh {
  // Numbers from 0 of what the lists below hold.
  struct Corner {
    int place, normal, texture;
  };

  // Lists name each value once, in the order in which corners come: x, y, z as whole steps from the
  // origin, unit vectors in thousandths, and texture coordinates in millimetres.
  std::vector<std::array<std::int64_t, 3>> places;
  std::vector<std::array<std::int64_t, 3>> normals;
  std::vector<std::array<std::int64_t, 2>> texture;
  // Triangles of each mesh, in their order. One two of whose corners are one place is left out.
  std::vector<std::vector<std::array<Corner, 3>>> triangles;
};

// A step is metres. Cancellable.
IndexedMesh indexed_mesh(const std::vector<const SurfaceMesh*>& meshes, const Point& origin,
                         double step);

}  // namespace streetgen
