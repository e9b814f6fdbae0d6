// The corners of a node share the ground that they may close.
#include "roadway/shared_ground.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "streetgen/streets.hpp"

namespace streetgen {
namespace shared_ground_test {

constexpr double any = std::numeric_limits<double>::infinity();

TEST(SharedGround, IsTakenFromTheLargestCorners) {
  EXPECT_EQ(shared_ground({{10, 1}, {20, 1}}, 50), (std::vector<double>{any, any}));
  const std::vector<double> shares = shared_ground({{10, 1}, {30, 1}, {40, 1}}, 50);
  EXPECT_EQ(shares[0], any);
  EXPECT_NEAR(shares[1], 20, 1e-5);
  EXPECT_NEAR(shares[2], 20, 1e-5);
}

TEST(SharedGround, LeavesOrdinaryCornersTheirRadius) {
  const std::vector<double> shares = shared_ground({{30, 30}, {30, 30}, {40, 30}}, 50);
  EXPECT_EQ(shares[0], any);
  EXPECT_EQ(shares[1], any);
  EXPECT_EQ(shares[2], 30);
}

// Streets that cross by an angle have two sharp corners and two wide ones.
std::vector<double> radii(double degrees, double wanted) {
  const double angle = degrees * M_PI / 180, x = 150 * std::cos(angle), y = 150 * std::sin(angle);
  std::vector<StreetAxis> axes;
  for (const Line& line : {Line{{0, 0, 0}, {150, 0, 0}}, Line{{0, 0, 0}, {x, y, 0}},
                           Line{{0, 0, 0}, {-150, 0, 0}}, Line{{0, 0, 0}, {-x, -y, 0}}})
    axes.push_back({static_cast<std::int64_t>(axes.size()) + 1, line, 0, 7, 7, wanted, 3});
  std::vector<double> found;
  for (const Corner& corner : streets(axes, {}).corners) found.push_back(corner.radius);
  return found;
}

// An arc leaves radius^2 (cot(angle / 2) - (pi - angle) / 2) to kerbs that part by an angle.
double ground(double degrees, double radius) {
  const double half = degrees * M_PI / 360;
  return radius * radius * (1 / std::tan(half) - M_PI / 2 + half);
}

TEST(SharedGround, BoundsSharpCornersOfOneNode) {
  double closed = 0;
  const std::vector<double> found = radii(45, 7);
  ASSERT_EQ(found.size(), 4u);
  for (const double radius : found)
    if (radius < 7) closed += ground(45, radius);
  closed += 2 * ground(135, 7);
  EXPECT_NEAR(closed, 50, 1e-3);
  for (const double degrees : {76.0, 90.0, 100.0})
    for (const double radius : radii(degrees, 10)) EXPECT_EQ(radius, 10) << degrees;
}

}  // namespace shared_ground_test
}  // namespace streetgen
