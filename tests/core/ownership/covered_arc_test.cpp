#include "ownership/covered_arc.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/geos.hpp"
#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "random_town.hpp"
#include "rounds.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {
namespace covered_arc_test {

StreetAxis axis(std::int64_t id, Line line, double width, int level = 0) {
  return {id, std::move(line), level, width, width, 5, 3};
}

// A street from the south comes to one along x; a third one along x lies so far south of it.
Streets beside_third(double away, int level = 0) {
  return streets(
      {axis(1, {{-100, 0, 0}, {0, 0, 0}}, 8), axis(2, {{0, 0, 0}, {100, 0, 0}}, 8),
       axis(3, {{0, 0, 0}, {0, -100, 0}}, 8), axis(4, {{3, -away, 0}, {90, -away, 0}}, 12, level)},
      {});
}

const Corner& south_east(const Streets& town) {
  return *std::find_if(town.corners.begin(), town.corners.end(),
                       [](const Corner& c) { return c.edge_a == 2 && c.edge_b == 1; });
}

TEST(CoveredArc, ACornerHasNoneWhereAnotherStreetLiesBehindIt) {
  const Corner& corner = south_east(beside_third(8));
  EXPECT_EQ(corner.method, Method::covered);
  EXPECT_FALSE(corner.arc);
  EXPECT_FALSE(corner.centre);
  EXPECT_EQ(corner.radius, 0);
  EXPECT_EQ(corner.radius_wanted, 5);
}

TEST(CoveredArc, ACornerKeepsItBesideOtherGroundAndUnderABridge) {
  for (const Streets& town : {beside_third(30), beside_third(8, 1)}) {
    const Corner& corner = south_east(town);
    EXPECT_EQ(corner.method, Method::hypothesis);
    EXPECT_EQ(corner.radius, 5);
    EXPECT_TRUE(corner.arc);
  }
}

// A place behind the middle of an arc may be covered, but not it and two thirds of the others.
TEST(CoveredArc, WhatIsLeftInRandomTownsHasGroundBehindIt) {
  Geos geos;
  int corners = 0, none = 0;
  for (int seed = 1; seed <= rounds(20); ++seed) {
    const Streets town = streets(random_town(seed, 30), {});
    std::vector<MultiPolygon> surfaces;
    for (const Section& section : town.sections) surfaces.push_back(section.surface);
    for (const Intersection& one : town.intersections) surfaces.push_back(one.surface);
    const MultiPolygon roadway = geos.polygons(geos.unite(surfaces).get());
    const PreparedSurface ground(roadway);
    for (const Corner& corner : town.corners) {
      none += corner.method == Method::covered;
      if (!corner.arc || corner.radius < 0.5) continue;
      ++corners;
      const Point& centre = *corner.centre;
      const double size = distance(corner.arc->start, corner.arc->middle);
      if (size < 0.5) continue;
      const auto behind = [&](const Point& p) { return ground.holds(p + unit(centre - p) * 0.05); };
      const Point quarter = centre + unit((corner.arc->start + corner.arc->middle) * 0.5 - centre) *
                                         corner.radius,
                  other = centre + unit((corner.arc->end + corner.arc->middle) * 0.5 - centre) *
                                       corner.radius;
      EXPECT_FALSE(behind(quarter) && behind(corner.arc->middle) && behind(other))
          << "seed " << seed << " at " << corner.arc->middle.x << " " << corner.arc->middle.y;
    }
  }
  EXPECT_GT(corners, 10 * rounds(20));
  EXPECT_GT(none, 0);
}

}  // namespace covered_arc_test
}  // namespace streetgen
