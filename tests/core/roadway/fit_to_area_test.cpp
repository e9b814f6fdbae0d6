// Streets with areas that were surveyed as their roadway.
#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/geos.hpp"
#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {
namespace fit_to_area_test {

MultiPolygon box(double west, double south, double east, double north) {
  return {{{{west, south}, {east, south}, {east, north}, {west, north}, {west, south}}}};
}

MultiPolygon united(const std::vector<MultiPolygon>& parts) {
  Geos geos;
  return geos.polygons(geos.unite(parts).get());
}

// A street of 8 m from west to east, and one of 6 m that comes to it from the north.
std::vector<StreetAxis> tee(const MultiPolygon& area, const MultiPolygon& of_north) {
  std::vector<StreetAxis> axes(2);
  axes[0] = {1, {{-100, 0}, {100, 0}}, 0, 8, 8, 6, 3};
  axes[1] = {2, {{0, 0}, {0, 100}}, 0, 6, 6, 6, 4};
  axes[0].area = area;
  axes[1].area = of_north;
  return axes;
}

double total(const Streets& town) {
  double sum = 0;
  for (const Section& section : town.sections) sum += area(section.surface);
  for (const Intersection& intersection : town.intersections) sum += area(intersection.surface);
  return sum;
}

bool holds(const Streets& town, const Point& place) {
  const auto has = [&](const auto& row) { return inside(place, row.surface); };
  return std::any_of(town.sections.begin(), town.sections.end(), has) ||
         std::any_of(town.intersections.begin(), town.intersections.end(), has);
}

const MultiPolygon crossing_areas =
    united({box(-100, -5, 100, 4), box(-3, 3, 3, 100), box(20, 3, 40, 6)});

TEST(FitToArea, TheSurfacesOfAllAxesAreTheArea) {
  const Streets town = streets(tee(crossing_areas, crossing_areas), {});
  EXPECT_NEAR(total(town), area(crossing_areas), 1e-5);
  EXPECT_TRUE(holds(town, {30, 5.5}));  // a bay
  EXPECT_TRUE(holds(town, {0, -4.5}));  // beyond the kerb
  EXPECT_FALSE(holds(town, {4, 4.5}));  // within the corner of 6 m
  EXPECT_TRUE(holds(streets(tee({}, {}), {}), {4, 4.5}));
}

TEST(FitToArea, AnAxisWithoutAnAreaKeepsItsGround) {
  const Streets town = streets(tee(box(-100, -5, 100, 4), {}), {});
  for (const double north : {4.1, 6.0, 9.0, 12.0, 90.0}) {
    EXPECT_TRUE(holds(town, {2.9, north})) << north;
    EXPECT_TRUE(holds(town, {-2.9, north})) << north;
  }
  EXPECT_FALSE(holds(town, {50, 4.1}));
}

TEST(FitToArea, WhereAnAreaEndsTheStreetGoesOn) {
  const Streets town = streets(tee(box(-60, -3, 100, 3), {}), {});
  EXPECT_FALSE(holds(town, {-50, 3.5}));
  EXPECT_TRUE(holds(town, {-70, 3.5}));
  EXPECT_TRUE(holds(town, {-99, -3.5}));
}

TEST(FitToArea, WhatLiesBetweenAnAreaAndTheNextKeepsTheKerbsOfTheAxis) {
  // The axis from the north leaves its area before it comes to the other street, askew.
  const MultiPolygon askew{{{{-3, 9}, {3, 7}, {3, 100}, {-3, 100}, {-3, 9}}}};
  const Streets town = streets(tee(box(-100, -5, 100, 4), askew), {});
  for (const double north : {4.1, 6.0, 7.5, 8.9, 12.0}) {
    EXPECT_TRUE(holds(town, {2.9, north})) << north;
    EXPECT_TRUE(holds(town, {-2.9, north})) << north;
  }
}

TEST(FitToArea, AreasThatTouchLeaveNoSlit) {
  MultiPolygon areas = box(-100, -5, 30, 7);
  areas.push_back(box(30.02, -5, 100, 7)[0]);
  const Streets town = streets(tee(areas, {}), {});
  EXPECT_TRUE(holds(town, {30.01, 3}));
  EXPECT_TRUE(holds(town, {30.01, -3}));
}

TEST(FitToArea, GroundThatLeadsAwayIsTakenForSixMetres) {
  const Streets town = streets(tee(united({box(-100, -4, 100, 4), box(50, -50, 60, -4)}), {}), {});
  EXPECT_TRUE(holds(town, {55, -9.9}));
  EXPECT_FALSE(holds(town, {55, -10.1}));
}

TEST(FitToArea, PartsOfTheAreaThatDoNotReachTheStreetAreLeftOut) {
  MultiPolygon areas = box(-100, -4, 100, 4);
  areas.push_back(box(-100, -9, 100, -6)[0]);
  const Streets town = streets(tee(areas, {}), {});
  EXPECT_FALSE(holds(town, {50, -7}));
  EXPECT_TRUE(holds(town, {50, -3}));
}

}  // namespace fit_to_area_test
}  // namespace streetgen
