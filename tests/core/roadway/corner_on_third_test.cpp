#include <gtest/gtest.h>

#include <cmath>

#include "geometry/geos.hpp"
#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {
namespace corner_on_third_test {

constexpr double half = 10, radius = 5;

StreetAxis axis(std::int64_t id, Line line, double width) {
  return {id, std::move(line), 0, width, width, radius, 3};
}

// A wide street along x, of two axes, and a narrow one that leaves it by an angle to the west.
Streets branching(double angle, bool mirrored) {
  const double side = mirrored ? -1 : 1;
  return streets(
      {axis(1, {{-150, 0, 0}, {0, 0, 0}}, 2 * half), axis(2, {{0, 0, 0}, {150, 0, 0}}, 2 * half),
       axis(3, {{0, 0, 0}, {-150 * std::cos(angle), side * 150 * std::sin(angle), 0}}, 4)},
      {});
}

const Corner& wide_corner(const Streets& town) {
  for (const Corner& corner : town.corners)
    if (corner.edge_a != 0 && corner.edge_b != 0) return corner;
  return town.corners.front();
}

// The kerb of the narrow street comes out from under that of the wide one to the west of the node.
TEST(CornerOnThird, LiesWhereANarrowStreetComesOutFromUnderAWideOne) {
  Geos geos;
  for (const bool mirrored : {false, true})
    for (const double degrees : {25.0, 35.0, 50.0}) {
      const double side = mirrored ? -1 : 1;
      const Streets town = branching(degrees * M_PI / 180, mirrored);
      const Corner& corner = wide_corner(town);
      ASSERT_TRUE(corner.arc) << degrees;
      EXPECT_DOUBLE_EQ(corner.radius, radius) << degrees;
      EXPECT_NEAR(std::min(side * corner.arc->start.y, side * corner.arc->end.y), half, 1e-9);
      EXPECT_LT(std::max(corner.arc->start.x, corner.arc->end.x), 0) << degrees;
      std::vector<MultiPolygon> surfaces;
      for (const Section& section : town.sections) surfaces.push_back(section.surface);
      for (const Intersection& one : town.intersections) surfaces.push_back(one.surface);
      const MultiPolygon roadway = geos.polygons(geos.unite(surfaces).get());
      const PreparedSurface ground(roadway);
      const Point middle = corner.arc->middle, out = unit(*corner.centre - middle) * 0.01;
      EXPECT_TRUE(ground.holds(middle - out)) << degrees;
      EXPECT_FALSE(ground.holds(middle + out)) << degrees;
    }
}

}  // namespace corner_on_third_test
}  // namespace streetgen
