#include "streetgen/mean_line.hpp"

#include <gtest/gtest.h>

#include "geometry/polyline.hpp"

namespace streetgen {
namespace mean_line_test {

TEST(MeanLine, RunsHalfwayBetweenTwoOffsets) {
  const Line left = {{0, 3, 0}, {97, 3, 0}, {97, 100, 0}};
  const Line right = {{0, 0, 0}, {100, 0, 0}, {100, 100, 0}};
  const Line mean = mean_line({left, right});
  ASSERT_EQ(mean.size(), 3u);
  EXPECT_NEAR(distance(mean[0], {0, 1.5, 0}), 0, 1e-9);
  EXPECT_NEAR(distance(mean[1], {98.5, 1.5, 0}), 0, 1e-9);
  EXPECT_NEAR(distance(mean[2], {98.5, 100, 0}), 0, 1e-9);
}

TEST(MeanLine, HasAVertexWhereOneLineHas) {
  const Line bent = {{0, 0, 0}, {10, 2, 0}, {20, 0, 0}, {40, 0, 0}};
  const Line straight = {{0, 4, 0}, {40, 4, 0}};
  const Line mean = mean_line({bent, straight, straight});
  EXPECT_EQ(mean.size(), 4u);
  EXPECT_NEAR(mean[0].y, 8.0 / 3, 1e-9);
  EXPECT_NEAR(mean[1].y, 10.0 / 3, 1e-9);
}

TEST(MeanLine, OfLinesThatCancelOutIsNothing) {
  EXPECT_TRUE(mean_line({{{0, 0, 0}, {1, 0, 0}}, {{1, 0, 0}, {0, 0, 0}}}).empty());
  EXPECT_TRUE(mean_line({}).empty());
  EXPECT_EQ(mean_line({{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}}}).size(), 2u);
}

}  // namespace mean_line_test
}  // namespace streetgen
