#include "streetgen/object_shape.hpp"

#include <gtest/gtest.h>

#include "geometry/polyline.hpp"
#include "geometry/space.hpp"

namespace streetgen {
namespace object_shape_test {

// The volume that triangles enclose, seen from outside.
double volume(const SurfaceMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) sum += space::dot(a, space::cross(b, c)) / 6;
  return sum;
}

TEST(ObjectShape, StandsOnTheGroundAndIsSeenFromOutside) {
  for (const char* kind : {"tree", "lamp", "traffic_light", "sign", "bus_stop", "protection",
                           "furniture", "something"}) {
    const ObjectShape shape = object_shape(kind);
    EXPECT_FALSE(shape.head.triangles.empty()) << kind;
    double least = 1e9;
    for (const SurfaceMesh* part : {&shape.post, &shape.head}) {
      EXPECT_EQ(part->normals.size(), 3 * part->triangles.size());
      EXPECT_EQ(part->texture.size(), 3 * part->triangles.size());
      if (!part->triangles.empty()) EXPECT_GT(volume(*part), 0) << kind;
      for (const Triangle& triangle : part->triangles)
        for (const Point& corner : triangle) least = std::min(least, corner.z);
    }
    EXPECT_EQ(least, 0) << kind;
  }
}

TEST(ObjectShape, HasNoneForWhatLiesInTheGround) {
  for (const char* kind : {"manhole", "arrow", "calming"}) {
    EXPECT_TRUE(object_shape(kind).post.triangles.empty());
    EXPECT_TRUE(object_shape(kind).head.triangles.empty());
  }
}

TEST(ObjectShape, TurnsTheFaceOfASignToTheNorth) {
  double north = 0;
  const SurfaceMesh head = object_shape("sign").head;
  for (const Triangle& triangle : head.triangles)
    for (const Point& corner : triangle) north = std::max(north, corner.y);
  EXPECT_GT(north, 0.05);
}

}  // namespace object_shape_test
}  // namespace streetgen
