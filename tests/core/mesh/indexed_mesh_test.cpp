#include "streetgen/indexed_mesh.hpp"

#include <gtest/gtest.h>

namespace streetgen {
namespace indexed_mesh_test {

SurfaceMesh square(double east) {
  const Point a{650000 + east, 6860000, 7}, b{650004 + east, 6860000, 7},
      c{650004 + east, 6860003, 7}, d{650000 + east, 6860003, 7};
  SurfaceMesh mesh;
  mesh.triangles = {{a, b, c}, {a, c, d}};
  mesh.normals.assign(6, {0, 0, 1});
  mesh.texture = {{0, 0}, {4, 0}, {4, 3}, {0, 0}, {4, 3}, {0, 3}};
  return mesh;
}

TEST(IndexedMesh, NeighboursNameTheSamePlaces) {
  const SurfaceMesh west = square(0), east = square(4);
  const IndexedMesh indexed = indexed_mesh({&west, &east}, {650000, 6860000, 5}, 0.01);
  EXPECT_EQ(indexed.places.size(), 6u);
  EXPECT_EQ(indexed.normals, (std::vector<std::array<std::int64_t, 3>>{{0, 0, 1000}}));
  EXPECT_EQ(indexed.texture.size(), 4u);
  ASSERT_EQ(indexed.triangles.size(), 2u);
  for (std::size_t mesh = 0; mesh < 2; ++mesh)
    for (const auto& triangle : indexed.triangles[mesh])
      for (const IndexedMesh::Corner& corner : triangle) {
        const auto& [x, y, z] = indexed.places[corner.place];
        const auto& [along, aside] = indexed.texture[corner.texture];
        EXPECT_EQ(10 * x, along + 4000 * static_cast<std::int64_t>(mesh));
        EXPECT_EQ(10 * y, aside);
        EXPECT_EQ(z, 200);
      }
}

TEST(IndexedMesh, LeavesOutATriangleOfTwoPlaces) {
  SurfaceMesh mesh = square(0);
  mesh.triangles[1] = {Point{0, 0}, Point{0.001, 0.001}, Point{0, 1}};
  const IndexedMesh indexed = indexed_mesh({&mesh}, {0, 0, 0}, 0.01);
  ASSERT_EQ(indexed.triangles.size(), 1u);
  EXPECT_EQ(indexed.triangles[0].size(), 1u);
  EXPECT_EQ(indexed.places.size(), 3u);
}

}  // namespace indexed_mesh_test
}  // namespace streetgen
