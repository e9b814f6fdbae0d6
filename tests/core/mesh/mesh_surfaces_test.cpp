#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "geometry/polyline.hpp"
#include "geometry/space.hpp"
#include "mesh/axis_height.hpp"
#include "mesh/breakline.hpp"
#include "mesh/texture_place.hpp"
#include "streetgen/surface_mesh.hpp"

namespace streetgen {
namespace mesh_surfaces_test {

const Line east{{0, 0}, {1, 0}};

MultiPolygon rectangle(double x, double y, double to_x, double to_y) {
  return {{{{x, y}, {to_x, y}, {to_x, to_y}, {x, to_y}, {x, y}}}};
}

double area_of(const GroundMesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.ground.triangles) {
    const double own = cross(t[1] - t[0], t[2] - t[0]) / 2;
    EXPECT_GT(own, 0);
    sum += own;
  }
  return sum;
}

bool has_vertex(const GroundMesh& mesh, double x, double y) {
  const std::vector<Triangle>& all = mesh.ground.triangles;
  return std::any_of(all.begin(), all.end(), [&](const Triangle& t) {
    return std::any_of(t.begin(), t.end(), [&](const Point& p) { return p.x == x && p.y == y; });
  });
}

TEST(MeshSurfaces, GivesASideTheVerticesOfItsNeighbours) {
  const auto meshes = mesh_surfaces({{rectangle(0, 0, 10, 4), 0, east},
                                     {rectangle(0, 4, 3, 8), 0, east},
                                     {rectangle(3 + 1e-6, 4 + 1e-6, 10, 8), 0, east},
                                     {rectangle(5, 4, 6, 8), 1, east}},
                                    {}, 0.05);
  EXPECT_TRUE(has_vertex(meshes[0], 3, 4));
  EXPECT_TRUE(has_vertex(meshes[2], 3, 4));
  EXPECT_FALSE(has_vertex(meshes[0], 5, 4));
  EXPECT_NEAR(area_of(meshes[0]), 40, 1e-4);
  EXPECT_NEAR(area_of(meshes[2]), 28, 1e-4);
}

TEST(MeshSurfaces, LeavesHolesOpenAndMeshesEveryPart) {
  MultiPolygon ring = rectangle(0, 0, 10, 10);
  ring[0].push_back({{4, 4}, {4, 6}, {6, 6}, {6, 4}, {4, 4}});
  ring.push_back(rectangle(20, 0, 21, 1)[0]);
  const auto meshes =
      mesh_surfaces({{ring, 0, east}, {rectangle(4, 4, 6, 6), 0, east, 0, false}}, {}, 0.05);
  EXPECT_NEAR(area_of(meshes[0]), 97, 1e-9);
  EXPECT_TRUE(meshes[1].ground.triangles.empty());
}

TEST(MeshSurfaces, CutsASectionAcrossAtACrest) {
  const std::vector<HeightAxis> axes{{{{0, 0, 0}, {50, 0, 5}, {100, 0, 0}}, 0}};
  const auto mesh = mesh_surfaces({{rectangle(0, -4, 100, 4), 0, east}}, axes, 0.05)[0];
  for (const double y : {-4.0, 0.0, 4.0}) EXPECT_TRUE(has_vertex(mesh, 50, y));
  for (const Triangle& t : mesh.ground.triangles) {
    const auto [least, most] = std::minmax({t[0].x, t[1].x, t[2].x});
    EXPECT_FALSE(least < 50 && most > 50);
    for (const Point& p : t) EXPECT_DOUBLE_EQ(p.z, 5 - std::abs(p.x - 50) / 10);
  }
  EXPECT_NEAR(area_of(mesh), 800, 1e-9);
}

TEST(MeshSurfaces, TakesTheHeightOfTheRoadwayInWhichAVertexLies) {
  // The ramp ends nearer to the kerb than its own axis is.
  const std::vector<HeightAxis> axes{{{{0, 0, 0}, {100, 0, 0}}, 0, 6},
                                     {{{50, 8, 5}, {50, 80, 0}}, 0, 4}};
  const auto mesh = mesh_surfaces({{rectangle(0, -6, 100, 6), 0, east}}, axes, 0.05)[0];
  for (const Triangle& t : mesh.ground.triangles)
    for (const Point& p : t) EXPECT_EQ(p.z, 0) << p.x << ' ' << p.y;
}

TEST(MeshSurfaces, KeepsAnAxisThatEndsWithinItsSurface) {
  const std::vector<HeightAxis> axes{{{{0, 0, 0}, {50, 0, 5}}, 0}};
  const auto mesh = mesh_surfaces({{rectangle(0, -4, 60, 4), 0, east}}, axes, 0.05)[0];
  EXPECT_TRUE(has_vertex(mesh, 50, 0));
  EXPECT_TRUE(has_vertex(mesh, 60, 0));
  EXPECT_NEAR(area_of(mesh), 480, 1e-9);
}

// Sides of triangles without one the other way.
std::size_t open_sides(const std::vector<GroundMesh>& meshes) {
  std::map<std::array<double, 6>, int> uses;
  for (const GroundMesh& mesh : meshes)
    for (const auto* triangles : {&mesh.ground.triangles, &mesh.kerb.triangles})
      for (const Triangle& t : *triangles)
        for (int k = 0; k < 3; ++k) {
          const Point &a = t[k], &b = t[(k + 1) % 3];
          const bool forwards = std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
          const Point &low = forwards ? a : b, &high = forwards ? b : a;
          uses[{low.x, low.y, low.z, high.x, high.y, high.z}] += forwards ? 1 : -1;
        }
  return std::count_if(uses.begin(), uses.end(), [](const auto& use) { return use.second != 0; });
}

TEST(MeshSurfaces, ClosesTheStepToARaisedSurface) {
  const std::vector<HeightAxis> axes{{{{0, 2, 0}, {4, 2, 1}, {10, 2, 0}}, 0}};
  const auto meshes = mesh_surfaces({{rectangle(0, 0, 10, 4), 0, east},
                                     {rectangle(0, 4, 6, 6), 0, east, 0.15},
                                     {rectangle(6, 4, 10, 6), 0, east, 0.15}},
                                    axes, 0.01);
  double area = 0;
  for (const GroundMesh& mesh : meshes)
    for (std::size_t i = 0; i < mesh.kerb.triangles.size(); ++i) {
      const auto& [a, b, c] = mesh.kerb.triangles[i];
      area += space::norm(space::cross(b - a, c - a)) / 2;
      EXPECT_NEAR(mesh.kerb.normals[3 * i].y, -1, 1e-12);
      EXPECT_GE(mesh.kerb.texture[3 * i][1], 0);
      EXPECT_LE(mesh.kerb.texture[3 * i][1], 0.15 + 1e-12);
    }
  EXPECT_TRUE(meshes[0].kerb.triangles.empty());
  EXPECT_NEAR(area, 0.15 * 10, 1e-9);
  EXPECT_TRUE(has_vertex(meshes[1], 4, 4));
  // The rim of all three as one sheet: the ends of the kerb are its own.
  const std::size_t rim = open_sides(meshes);
  EXPECT_EQ(rim, open_sides(mesh_surfaces({{rectangle(0, 0, 10, 4), 0, east},
                                           {rectangle(0, 4, 6, 6), 0, east},
                                           {rectangle(6, 4, 10, 6), 0, east}},
                                          axes, 0.01)) +
                     2);
}

TEST(MeshSurfaces, KnowsNormalsAndTexture) {
  const std::vector<HeightAxis> axes{{{{0, 2, 0}, {10, 2, 5}}, 0}};
  const SurfaceMesh mesh =
      mesh_surfaces({{rectangle(0, 0, 10, 4), 0, {{0, 2}, {10, 2}}}}, axes, 0.01)[0].ground;
  ASSERT_EQ(mesh.normals.size(), 3 * mesh.triangles.size());
  ASSERT_EQ(mesh.texture.size(), 3 * mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    EXPECT_NEAR(mesh.normals[i].x, -0.5 / std::sqrt(1.25), 1e-12);
    EXPECT_NEAR(mesh.normals[i].z, 1 / std::sqrt(1.25), 1e-12);
    const Point& corner = mesh.triangles[i / 3][i % 3];
    EXPECT_NEAR(mesh.texture[i][0], corner.x, 1e-12);
    EXPECT_NEAR(mesh.texture[i][1], corner.y - 2, 1e-12);
  }
}

TEST(TexturePlace, GoesStraightOnAtTheEnds) {
  const Line line{{0, 0}, {10, 0}, {10, 10}};
  EXPECT_EQ(texture_place(line, {-3, 1}), (std::array<double, 2>{-3, 1}));
  EXPECT_EQ(texture_place(line, {11, 12}), (std::array<double, 2>{22, -1}));
  EXPECT_EQ(texture_place(line, {13, -4}), (std::array<double, 2>{10, -5}));
  EXPECT_EQ(texture_place(line, {4, -2}), (std::array<double, 2>{4, -2}));
}

TEST(AxisHeight, HasTheMeanNormalAtACrest) {
  const std::vector<HeightAxis> axes{{{{0, 0, 0}, {10, 0, 5}, {20, 0, 0}}, 0}};
  const AxisHeight height(axes);
  EXPECT_NEAR(height.normal({10, 3}, 0).z, 1, 1e-12);
  EXPECT_NEAR(height.normal({9, 3}, 0).x, -0.5 / std::sqrt(1.25), 1e-12);
  EXPECT_EQ(height.normal({9, 3}, 1).z, 1);
}

TEST(AxisHeight, IsThatOfTheNearestAxisOfTheLevel) {
  const std::vector<HeightAxis> axes{
      {{{0, 0, 1}, {10, 0, 2}}, 0}, {{{0, 8, 7}, {10, 8, 7}}, 0}, {{{0, 1, 30}, {10, 1, 30}}, 1}};
  const AxisHeight height(axes);
  EXPECT_DOUBLE_EQ(height.at({5, 3}, 0), 1.5);
  EXPECT_DOUBLE_EQ(height.at({5, 5}, 0), 7);
  EXPECT_DOUBLE_EQ(height.at({5, 4}, 0), 1.5);
  EXPECT_DOUBLE_EQ(height.at({5, 3}, 1), 30);
  EXPECT_DOUBLE_EQ(height.at({5, 3}, 2), 0);
  EXPECT_DOUBLE_EQ(height.at({2e6, 7}, 0), 7);
}

TEST(WithoutSlightBends, CountsHeights) {
  const Line line{{0, 0, 0}, {10, 0.01, 0}, {20, 0, 1}, {30, 0, 2}};
  EXPECT_EQ(without_slight_bends(line, 0.05).size(), 3u);
  EXPECT_EQ(without_slight_bends(line, 0.001).size(), 4u);
  EXPECT_EQ(without_slight_bends(line, 5).size(), 2u);
}

}  // namespace mesh_surfaces_test
}  // namespace streetgen
