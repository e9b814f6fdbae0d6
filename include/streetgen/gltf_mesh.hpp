// Meshes as the binary data of glTF 2.0.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "streetgen/surface_mesh.hpp"

namespace streetgen {

// The data of one primitive of triangles.
struct GltfMesh {
  std::uint32_t vertices = 0;
  std::uint32_t indices = 0;
  // The box of the positions, as the floats that are written.
  std::array<float, 3> least{}, most{};
  // Positions and normals (three floats a vertex), texture coordinates (two floats), then indices
  // of 32 bits, three a triangle; little-endian.
  std::string bytes;
};

// All meshes as one primitive: a vertex for each place with its normal and texture coordinates.
// x is to the east, y up, z to the south, metres from an origin. The second texture coordinate
// grows to the right of the line, so that an image has its top at the left of a road. A triangle
// with two corners that are one in floats is left out. Cancellable.
GltfMesh gltf_mesh(const std::vector<const SurfaceMesh*>& meshes, const Point& origin);

}  // namespace streetgen
