#include "streetgen/kerbs_by_area.hpp"

#include <gtest/gtest.h>

namespace streetgen {
namespace kerbs_by_area_test {

MultiPolygon box(double west, double south, double east, double north) {
  return {{{{west, south}, {east, south}, {east, north}, {west, north}, {west, south}}}};
}

const Line axis{{0, 0}, {100, 0}};

TEST(KerbsByArea, AreTheBordersOnBothSides) {
  const auto kerbs = kerbs_by_area(axis, {box(-10, -3, 110, 5)});
  ASSERT_TRUE(kerbs);
  EXPECT_NEAR(kerbs->width, 8, 1e-9);
  EXPECT_NEAR(kerbs->roadway_offset, 1, 1e-9);
  const auto back = kerbs_by_area({{100, 0}, {0, 0}}, {box(-10, -3, 110, 5)});
  EXPECT_NEAR(back->roadway_offset, -1, 1e-9);
}

TEST(KerbsByArea, AreasThatTouchAreOneAndOthersAreNot) {
  EXPECT_NEAR(
      kerbs_by_area(axis, {box(0, 2, 100, 4), box(0, -3, 50, 2), box(50, -3, 100, 2)})->width, 7,
      1e-9);
  EXPECT_NEAR(kerbs_by_area(axis, {box(0, 5, 100, 9), box(0, -3, 100, 4)})->width, 7, 1e-9);
}

TEST(KerbsByArea, MouthsOfOtherStreetsAndBaysAlongLessThanHalfChangeNothing) {
  const auto kerbs =
      kerbs_by_area(axis, {box(0, -3, 100, 4), box(20, 4, 40, 90), box(50, 4, 70, 6)});
  EXPECT_NEAR(kerbs->width, 7, 1e-9);
  EXPECT_NEAR(kerbs->roadway_offset, 0.5, 1e-9);
}

TEST(KerbsByArea, OneSideTellsBothWhereTheOtherIsTooFar) {
  // Both carriageways of a street as one area.
  const auto kerbs = kerbs_by_area(axis, {box(0, -3, 100, 11)});
  EXPECT_NEAR(kerbs->width, 6, 1e-9);
  EXPECT_NEAR(kerbs->roadway_offset, 0, 1e-9);
  EXPECT_NEAR(kerbs_by_area(axis, {box(0, -3, 100, 300)})->width, 6, 1e-9);
}

TEST(KerbsByArea, AnAxisMayLieNearOneKerbOfItsStreet) {
  const auto kerbs = kerbs_by_area(axis, {box(-10, -5, 110, 1)});
  EXPECT_NEAR(kerbs->width, 6, 1e-9);
  EXPECT_NEAR(kerbs->roadway_offset, -2, 1e-9);
}

TEST(KerbsByArea, AreNoneWhereAreasDoNotTell) {
  EXPECT_FALSE(kerbs_by_area(axis, {}));
  EXPECT_FALSE(kerbs_by_area(axis, {box(0, 1, 100, 5)}));  // beside the axis
  EXPECT_FALSE(kerbs_by_area(axis, {box(0, -3, 29, 3)}));  // along less than 0.3 of it
  EXPECT_TRUE(kerbs_by_area(axis, {box(0, -3, 31, 3)}));
  EXPECT_FALSE(kerbs_by_area(axis, {box(0, -99, 100, 99)}));    // no border
  EXPECT_FALSE(kerbs_by_area(axis, {box(0, -0.2, 100, 0.2)}));  // no street
  EXPECT_FALSE(kerbs_by_area({{0, 0}, {20, 0}}, {box(0, -3, 5, 3)}));
  EXPECT_TRUE(kerbs_by_area({{0, 0}, {20, 0}}, {box(0, -3, 7, 3)}));
}

TEST(KerbsByArea, AnIslandOnTheAxisIsLeftOut) {
  MultiPolygon area = box(0, -6, 100, 6);
  area[0].push_back({{40, -1}, {40, 1}, {60, 1}, {60, -1}, {40, -1}});
  EXPECT_NEAR(kerbs_by_area(axis, {area})->width, 12, 1e-9);
}

}  // namespace kerbs_by_area_test
}  // namespace streetgen
