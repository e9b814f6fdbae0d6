#include "streetgen/common_ground.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/polyline.hpp"

namespace streetgen {
namespace common_ground_test {

const Line street = {{0, 0, 5}, {60, 0, 7}, {100, 0, 0}};

Line moved(Line line, double x, double y) {
  for (Point& p : line) p = p + Point{x, y, 0};
  return line;
}

TEST(CommonGround, ALineSharesAllWithItselfEitherWay) {
  EXPECT_DOUBLE_EQ(common_ground(street, street, 10), 1);
  EXPECT_DOUBLE_EQ(common_ground(street, reversed(street), 10), 1);
}

TEST(CommonGround, TwoStripsShareWhatTheirGapLeaves) {
  for (double gap = 0; gap < 25; gap += 2.5)
    EXPECT_NEAR(common_ground(street, moved(street, 0, gap), 10), std::max(0.0, 1 - gap / 20),
                1e-12);
}

TEST(CommonGround, APieceSharesAllOfItselfAndItsPartOfTheWhole) {
  const Line piece = {{20, 0, 0}, {50, 0, 0}};
  EXPECT_DOUBLE_EQ(common_ground(piece, street, 10), 1);
  EXPECT_NEAR(common_ground(street, piece, 10), 0.3, 0.02);
}

TEST(CommonGround, ACrossingOrFollowingStreetSharesNearlyNothing) {
  EXPECT_LE(common_ground(street, {{50, -80, 0}, {50, 80, 0}}, 10), 0.02);
  EXPECT_LE(common_ground(street, {{100, 0, 0}, {180, 0, 0}}, 10), 0.02);
  EXPECT_LE(common_ground({{0, 0, 0}, {20, 0, 0}}, {{20, -80, 0}, {20, 80, 0}}, 10), 0.1);
}

TEST(CommonGround, ALineWithoutLengthSharesNothing) {
  EXPECT_EQ(common_ground({{3, 3, 0}, {3, 3, 0}}, street, 10), 0);
  EXPECT_EQ(common_ground(street, {{3, 3, 0}, {3, 3, 0}}, 10), 0);
}

TEST(CommonGround, ACurvedStreetIsItselfWhenDrawnByOtherVerticesWithinHalfAMetre) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> off(-0.5, 0.5);
  const auto bend = [&](int pieces) {
    Line line;
    for (int i = 0; i <= pieces; ++i) {
      const double turn = 2.0 * i / pieces;
      line.push_back({60 * std::sin(turn) + off(random), 60 * std::cos(turn) + off(random), 0});
    }
    return line;
  };
  for (int round = 0; round < 50; ++round)
    EXPECT_GT(common_ground(bend(9 + round), bend(40), 10), 0.9);
}

}  // namespace common_ground_test
}  // namespace streetgen
