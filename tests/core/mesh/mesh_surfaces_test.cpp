#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"
#include "mesh/axis_height.hpp"
#include "mesh/breakline.hpp"
#include "streetgen/surface_mesh.hpp"

namespace streetgen {
namespace {

MultiPolygon rectangle(double x, double y, double to_x, double to_y) {
  return {{{{x, y}, {to_x, y}, {to_x, to_y}, {x, to_y}, {x, y}}}};
}

double area_of(const std::vector<Triangle>& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh) {
    const double own = cross(t[1] - t[0], t[2] - t[0]) / 2;
    EXPECT_GT(own, 0);
    sum += own;
  }
  return sum;
}

bool has_vertex(const std::vector<Triangle>& mesh, double x, double y) {
  return std::any_of(mesh.begin(), mesh.end(), [&](const Triangle& t) {
    return std::any_of(t.begin(), t.end(), [&](const Point& p) { return p.x == x && p.y == y; });
  });
}

TEST(MeshSurfaces, GivesASideTheVerticesOfItsNeighbours) {
  const auto meshes = mesh_surfaces({{rectangle(0, 0, 10, 4), 0},
                                     {rectangle(0, 4, 3, 8), 0},
                                     {rectangle(3 + 1e-6, 4 + 1e-6, 10, 8), 0},
                                     {rectangle(5, 4, 6, 8), 1}},
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
  const auto meshes = mesh_surfaces({{ring, 0}, {rectangle(4, 4, 6, 6), 0, false}}, {}, 0.05);
  EXPECT_NEAR(area_of(meshes[0]), 97, 1e-9);
  EXPECT_TRUE(meshes[1].empty());
}

TEST(MeshSurfaces, CutsASectionAcrossAtACrest) {
  const std::vector<HeightAxis> axes{{{{0, 0, 0}, {50, 0, 5}, {100, 0, 0}}, 0}};
  const auto mesh = mesh_surfaces({{rectangle(0, -4, 100, 4), 0}}, axes, 0.05)[0];
  for (const double y : {-4.0, 0.0, 4.0}) EXPECT_TRUE(has_vertex(mesh, 50, y));
  for (const Triangle& t : mesh) {
    const auto [least, most] = std::minmax({t[0].x, t[1].x, t[2].x});
    EXPECT_FALSE(least < 50 && most > 50);
    for (const Point& p : t) EXPECT_DOUBLE_EQ(p.z, 5 - std::abs(p.x - 50) / 10);
  }
  EXPECT_NEAR(area_of(mesh), 800, 1e-9);
}

TEST(MeshSurfaces, KeepsAnAxisThatEndsWithinItsSurface) {
  const std::vector<HeightAxis> axes{{{{0, 0, 0}, {50, 0, 5}}, 0}};
  const auto mesh = mesh_surfaces({{rectangle(0, -4, 60, 4), 0}}, axes, 0.05)[0];
  EXPECT_TRUE(has_vertex(mesh, 50, 0));
  EXPECT_TRUE(has_vertex(mesh, 60, 0));
  EXPECT_NEAR(area_of(mesh), 480, 1e-9);
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

}  // namespace
}  // namespace streetgen
