#include "streetgen/duplicate_line.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace streetgen {

namespace duplicate_line_test {

constexpr double near = 0.3;

double of_first(const Line& line, const Line& other, int level = 0) {
  return doubled({line, other}, {0, level}, near)[0];
}

TEST(Doubled, LinesOnEachOther) {
  EXPECT_DOUBLE_EQ(of_first({{0, 0}, {100, 0}}, {{0, 0}, {100, 0}}), 100);
  EXPECT_DOUBLE_EQ(of_first({{0, 0}, {100, 0}}, {{100, 0.2}, {0, 0.2}}), 100);
  EXPECT_DOUBLE_EQ(of_first({{0, 0}, {100, 0}}, {{0, 0.4}, {100, 0.4}}), 0);
  EXPECT_DOUBLE_EQ(of_first({{0, 0}, {100, 0}}, {{40, 0}, {70, 0}}), 30);
}

TEST(Doubled, AnotherLevelIsNotOnIt) {
  EXPECT_EQ(of_first({{0, 0}, {100, 0}}, {{0, 0}, {100, 0}}, 1), 0);
}

TEST(Doubled, VerticesOfOneNeedNotBeThoseOfTheOther) {
  const Line bent{{0, 0}, {30, 0}, {60, 10}}, parted{{0, 0}, {10, 0}, {25, 0}, {30, 0}, {45, 5}};
  EXPECT_NEAR(of_first(bent, parted), 30 + std::hypot(15, 5), 1e-9);
  EXPECT_NEAR(of_first(parted, bent), 30 + std::hypot(15, 5), 1e-9);
}

TEST(Doubled, StreetsThatMeetShareTheirNode) {
  EXPECT_EQ(of_first({{0, 0}, {100, 0}}, {{100, 0}, {100, 50}}), 0);
  EXPECT_EQ(of_first({{0, 0}, {100, 0}}, {{100, 0}, {200, 0}}), 0);
  EXPECT_EQ(of_first({{0, 0}, {100, 0}}, {{50, -50}, {50, 50}}), 0);
}

// Of a wedge of one in twenty, what lies between its legs up to the distance.
TEST(Doubled, AFlatWedgeAsFarAsItIsNarrow) {
  EXPECT_NEAR(of_first({{0, 0}, {100, 5}}, {{0, 0}, {100, 0}}), near * std::hypot(20, 1), 1e-9);
}

TEST(Doubled, TheOneOtherWithMost) {
  const Line line{{0, 0}, {100, 0}};
  EXPECT_DOUBLE_EQ(doubled({line, {{0, 0}, {40, 0}}, {{30, 0}, {90, 0}}}, {0, 0, 0}, near)[0], 60);
}

TEST(Doubled, GroundIsCountedOnce) {
  const Line line{{0, 0}, {100, 0}}, there_and_back{{10, 0}, {60, 0}, {60, 0.1}, {20, 0.1}};
  EXPECT_NEAR(of_first(line, there_and_back), 50, 1e-9);
}

TEST(Doubled, ALineIsNotItsOwnOther) {
  EXPECT_EQ(doubled({{{0, 0}, {100, 0}, {100, 0.1}, {0, 0.1}}}, {0}, near)[0], 0);
  EXPECT_TRUE(doubled({}, {}, near).empty());
}

}  // namespace duplicate_line_test
}  // namespace streetgen
