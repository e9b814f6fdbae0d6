#include "streetgen/gltf_mesh.hpp"

#include <gtest/gtest.h>

#include <cstring>

namespace streetgen {
namespace gltf_mesh_test {

float float_at(const std::string& bytes, std::size_t number) {
  float value;
  std::memcpy(&value, bytes.data() + 4 * number, 4);
  return value;
}

SurfaceMesh square() {
  const Point a{650000, 6860000, 7}, b{650004, 6860000, 7}, c{650004, 6860003, 7},
      d{650000, 6860003, 7};
  SurfaceMesh mesh;
  mesh.triangles = {{a, b, c}, {a, c, d}};
  mesh.normals.assign(6, {0, 0, 1});
  mesh.texture = {{0, 0}, {4, 0}, {4, 3}, {0, 0}, {4, 3}, {0, 3}};
  return mesh;
}

TEST(GltfMesh, SharesVerticesAndTurnsUpToY) {
  const SurfaceMesh mesh = square();
  const GltfMesh packed = gltf_mesh({&mesh}, {650000, 6860000, 5});
  EXPECT_EQ(packed.vertices, 4u);
  EXPECT_EQ(packed.indices, 6u);
  EXPECT_EQ(packed.bytes.size(), 4u * 32 + 6 * 4);
  EXPECT_EQ(packed.least, (std::array<float, 3>{0, 2, -3}));
  EXPECT_EQ(packed.most, (std::array<float, 3>{4, 2, 0}));
  EXPECT_EQ(float_at(packed.bytes, 8), -3);      // z of the third vertex: three metres north
  EXPECT_EQ(float_at(packed.bytes, 12 + 1), 1);  // its normals point up
  EXPECT_EQ(float_at(packed.bytes, 24 + 5), -3);
}

TEST(GltfMesh, LeavesOutWhatAFloatCannotTellApart) {
  SurfaceMesh mesh = square();
  mesh.triangles[1] = {Point{1e5, 0}, Point{1e5 + 1e-4, 0}, Point{1e5, 1}};
  const GltfMesh packed = gltf_mesh({&mesh}, {0, 0, 0});
  EXPECT_EQ(packed.indices, 3u);
}

TEST(GltfMesh, IsEmptyOfNothing) {
  EXPECT_EQ(gltf_mesh({}, {}).vertices, 0u);
  EXPECT_TRUE(gltf_mesh({}, {}).bytes.empty());
}

}  // namespace gltf_mesh_test
}  // namespace streetgen
