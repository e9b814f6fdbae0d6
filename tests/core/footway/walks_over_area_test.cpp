#include <gtest/gtest.h>

#include "geometry/polyline.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/walk_network.hpp"

namespace streetgen {
namespace {

MultiPolygon square(double size) {
  return {{{{0, 0}, {size, 0}, {size, size}, {0, size}, {0, 0}}}};
}

TEST(WalksOverArea, LeadStraightBetweenPlacesThatSeeEachOther) {
  const auto walks = walks_over_area(square(40), {{0, 20}, {40, 20}, {20, 0}}, {}, 1.1);
  ASSERT_EQ(walks.size(), 3u);
  EXPECT_EQ(walks[2].from, 0);
  EXPECT_EQ(walks[2].to, 1);
  EXPECT_NEAR(walks[2].metres, 40, 1e-9);
  EXPECT_EQ(walks[2].line.size(), 2u);
}

TEST(WalksOverArea, LeaveOutWhatOthersLeadToNearlyAsShort) {
  // The third place lies nearly between the others.
  EXPECT_EQ(walks_over_area(square(10), {{0, 5}, {10, 5}, {5, 5.5}}, {}, 1.1).size(), 2u);
  // A walk of the source is there.
  EXPECT_TRUE(walks_over_area(square(10), {{0, 5}, {10, 5}}, {{0, 1, {}, 10.5}}, 1.1).empty());
  EXPECT_EQ(walks_over_area(square(10), {{0, 5}, {10, 5}}, {{0, 1, {}, 14}}, 1.1).size(), 0u);
  EXPECT_EQ(walks_over_area(square(10), {{0, 5}, {10, 5}}, {{0, 1, {}, 16}}, 1.1).size(), 1u);
}

TEST(WalksOverArea, BendAboutCornersAndHoles) {
  const MultiPolygon corner{{{{0, 0}, {20, 0}, {20, 20}, {10, 20}, {10, 10}, {0, 10}, {0, 0}}}};
  const auto about = walks_over_area(corner, {{0, 9}, {11, 20}}, {}, 1.1);
  ASSERT_EQ(about.size(), 1u);
  ASSERT_EQ(about[0].line.size(), 3u);
  EXPECT_TRUE(same(about[0].line[1], {10, 10}));
  MultiPolygon holed = square(10);
  holed[0].push_back({{4, 4}, {4, 6}, {6, 6}, {6, 4}, {4, 4}});
  const auto beside = walks_over_area(holed, {{0, 4.5}, {10, 4.5}}, {}, 1.1);
  ASSERT_EQ(beside.size(), 1u);
  ASSERT_EQ(beside[0].line.size(), 4u);
  EXPECT_TRUE(same(beside[0].line[1], {4, 4}));
}

TEST(WalksOverArea, PartsAreNotJoined) {
  MultiPolygon parts = square(10);
  parts.push_back({{{20, 0}, {30, 0}, {30, 10}, {20, 10}, {20, 0}}});
  EXPECT_TRUE(walks_over_area(parts, {{5, 5}, {25, 5}}, {}, 1.1).empty());
  EXPECT_EQ(walks_over_area(parts, {{5, 5}, {8, 5}, {25, 5}}, {}, 1.1).size(), 1u);
}

TEST(WalksOverArea, OneOfNoLengthIsNone) {
  EXPECT_TRUE(walks_over_area(square(10), {{5, 5}, {5, 5}}, {}, 1.1).empty());
  EXPECT_TRUE(walks_over_area({}, {{5, 5}, {6, 5}}, {}, 1.1).empty());
}

int polls_of_walks = 0;

TEST(WalksOverArea, CanBeCancelledBetweenAnyTwoSightsAndAnyTwoStepsOfAWay) {
  MultiPolygon holed = square(100);
  for (int i = 0; i < 10; ++i) {
    const double x = 5 + 9 * i;
    holed[0].push_back({{x, 5}, {x, 95}, {x + 1, 95}, {x + 1, 5}, {x, 5}});
  }
  std::vector<Point> places;
  for (int i = 0; i < 10; ++i) places.push_back({2.0 + 9 * i, 0});
  polls_of_walks = 0;
  set_cancel_check([]() noexcept { return ++polls_of_walks < 0; });
  walks_over_area(holed, places, {}, 1.1);
  set_cancel_check(nullptr);
  const int points = 10 + 4 * 10;
  EXPECT_GE(polls_of_walks, points * (points - 1) / 2 + 10 * points);
}

}  // namespace
}  // namespace streetgen
