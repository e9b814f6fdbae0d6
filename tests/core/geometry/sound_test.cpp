#include "streetgen/sound.hpp"

#include <gtest/gtest.h>

namespace streetgen {
namespace sound_test {

MultiPolygon rectangle(double west, double south, double east, double north) {
  return {{{{west, south}, {east, south}, {east, north}, {west, north}, {west, south}}}};
}

TEST(Sound, NeighboursShareNoGround) {
  EXPECT_FALSE(share_ground(rectangle(0, 0, 10, 5), rectangle(10, 0, 20, 5)));
  EXPECT_TRUE(share_ground(rectangle(0, 0, 10, 5), rectangle(9.9, 0, 20, 5)));
  EXPECT_TRUE(share_ground(rectangle(0, 0, 10, 5), rectangle(0, 0, 10, 5)));
  EXPECT_TRUE(share_ground(rectangle(0, 0, 10, 5), rectangle(2, 2, 3, 3)));
}

TEST(Sound, ARingThatMeetsItselfIsNotSurelyValid) {
  EXPECT_TRUE(surely_valid(rectangle(0, 0, 10, 5)));
  EXPECT_FALSE(surely_valid({{{{0, 0}, {10, 5}, {10, 0}, {0, 5}, {0, 0}}}}));
  EXPECT_FALSE(surely_valid({{{{0, 0}, {10, 0}, {5, 0}, {0, 5}, {0, 0}}}}));
  // A hole may lie anywhere.
  MultiPolygon holed = rectangle(0, 0, 10, 5);
  holed[0].push_back(rectangle(20, 0, 30, 5)[0][0]);
  EXPECT_FALSE(surely_valid(holed));
}

TEST(Sound, ALineLiesOnSurfacesThatFollowEachOther) {
  const std::vector<MultiPolygon> street{rectangle(0, 0, 10, 5), rectangle(10, 0, 20, 5)};
  EXPECT_TRUE(lies_on({{0, 2}, {20, 3}}, street));
  EXPECT_TRUE(lies_on({{1, 1}, {10, 4}, {19, 1}}, street));
  EXPECT_FALSE(lies_on({{0, 2}, {20.1, 3}}, street));
  EXPECT_FALSE(lies_on({{1, 1}, {12, 6}, {19, 1}}, street));
  EXPECT_FALSE(lies_on({{1, 1}, {25, 1}}, {rectangle(0, 0, 10, 5), rectangle(11, 0, 30, 5)}));
}

}  // namespace sound_test
}  // namespace streetgen
