#include "streetgen/gltf_mesh.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <functional>
#include <unordered_map>
#include <utility>

#include "geometry/polyline.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

// Position, normal and texture coordinates.
using Vertex = std::array<float, 8>;

struct VertexHash {
  std::size_t operator()(const Vertex& vertex) const {
    std::size_t hash = 0;
    for (const float value : vertex) hash = hash * 0x9e3779b97f4a7c15 + std::hash<float>()(value);
    return hash;
  }
};

Vertex vertex_of(const Point& place, const Point& normal, const std::array<double, 2>& texture) {
  const auto of = [](double value) { return static_cast<float>(value) + 0.0f; };  // no -0
  return {of(place.x),  of(place.z),   of(-place.y),   of(normal.x),
          of(normal.z), of(-normal.y), of(texture[0]), of(-texture[1])};
}

template <class Value>
void put(std::string& bytes, Value value) {
  static_assert(sizeof(Value) == 4);
  std::uint32_t word;
  std::memcpy(&word, &value, 4);
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift & 0xff);
}

}  // namespace

GltfMesh gltf_mesh(const std::vector<const SurfaceMesh*>& meshes, const Point& origin) {
  std::unordered_map<Vertex, std::uint32_t, VertexHash> numbers;
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;
  for (const SurfaceMesh* mesh : meshes) {
    poll_cancel();
    for (std::size_t i = 0; i < mesh->triangles.size(); ++i) {
      std::array<Vertex, 3> corners;
      for (std::size_t k = 0; k < 3; ++k)
        corners[k] = vertex_of(mesh->triangles[i][k] - origin, mesh->normals[3 * i + k],
                               mesh->texture[3 * i + k]);
      const auto one_place = [&](int a, int b) {
        return std::equal(corners[a].begin(), corners[a].begin() + 3, corners[b].begin());
      };
      if (one_place(0, 1) || one_place(1, 2) || one_place(2, 0)) continue;
      for (const Vertex& corner : corners) {
        const auto [known, added] =
            numbers.try_emplace(corner, static_cast<std::uint32_t>(vertices.size()));
        if (added) vertices.push_back(corner);
        indices.push_back(known->second);
      }
    }
  }
  GltfMesh packed;
  packed.vertices = static_cast<std::uint32_t>(vertices.size());
  packed.indices = static_cast<std::uint32_t>(indices.size());
  packed.bytes.reserve(32 * vertices.size() + 4 * indices.size());
  for (const auto& [first, last] : {std::pair(0, 3), std::pair(3, 6), std::pair(6, 8)})
    for (const Vertex& vertex : vertices)
      for (int k = first; k < last; ++k) put(packed.bytes, vertex[k]);
  for (const std::uint32_t index : indices) put(packed.bytes, index);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      packed.least[k] = i == 0 ? vertices[i][k] : std::min(packed.least[k], vertices[i][k]);
      packed.most[k] = i == 0 ? vertices[i][k] : std::max(packed.most[k], vertices[i][k]);
    }
  return packed;
}

}  // namespace streetgen
