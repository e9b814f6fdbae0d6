#include <gtest/gtest.h>

#include <cmath>

#include "streetgen/corner.hpp"
#include "streetgen/error.hpp"

namespace streetgen {

namespace turning_radius_test {
constexpr const char* modes[] = {"paper", "setra"};

TEST(TurningRadius, PaperIsEquationOne) {
  // The limit speed is 10 w + 65 with w the half width: 100 km/h for a street of 7 m.
  EXPECT_NEAR(turning_radius(20, 7, "paper"), std::sqrt(346.0) * std::sqrt(20.0 / 80), 1e-9);
  EXPECT_NEAR(turning_radius(30, 7, "paper"), 12.2, 0.05);
}

TEST(TurningRadius, SetraInvertsItsLaw) {
  for (const double speed : {1.0, 5.0, 10.0, 14.0}) {
    const double radius = turning_radius(speed, 7, "setra");
    EXPECT_NEAR(100 / (1 + 346 / std::pow(radius, 1.5)), speed, 1e-9);
  }
}

TEST(TurningRadius, StaysBetweenAKerbStoneAndFifteenMetres) {
  for (const char* mode : modes) {
    EXPECT_EQ(turning_radius(0, 7, mode), 0.15);
    for (const double speed : {99.0, 100.0, 101.0, 400.0})
      EXPECT_EQ(turning_radius(speed, 7, mode), 15) << speed;
  }
}

TEST(TurningRadius, StaysBetweenTheBoundsGiven) {
  // At 50 km/h and 7 m the law gives sqrt(346), beyond the bound of 15 m.
  EXPECT_NEAR(turning_radius(50, 7, "paper", 0, 200), std::sqrt(346.0), 1e-9);
  for (const char* mode : modes) {
    EXPECT_EQ(turning_radius(0, 7, mode, 2, 12), 2);
    EXPECT_EQ(turning_radius(99, 7, mode, 2, 12), 12);
  }
}

TEST(TurningRadius, GrowsWithSpeedAndShrinksWithWidth) {
  for (const char* mode : modes) {
    for (int speed = 0; speed < 400; ++speed)
      EXPECT_LE(turning_radius(speed, 7, mode), turning_radius(speed + 1, 7, mode)) << speed;
    EXPECT_LT(turning_radius(5, 7, mode), turning_radius(10, 7, mode));
    EXPECT_GT(turning_radius(10, 5, mode), turning_radius(10, 9, mode));
  }
}

TEST(TurningRadius, RefusesAnUnknownMode) { EXPECT_THROW(turning_radius(30, 7, "guess"), Error); }

}  // namespace turning_radius_test
}  // namespace streetgen
