#include "lane/lane_change.hpp"

#include <gtest/gtest.h>

#include "geometry/geos.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {
namespace lane_change_test {

// A street of 100 m along x with so many lanes against and along it, from left to right 1, 2, …
Lanes on_street(const AxisLanes& wanted, const PaintRules& paint) {
  return lanes(streets({{1, {{0, 0, 0}, {100, 0, 0}}, 0, 16, 16, 5, 3}}, {}), {{1, wanted}}, {}, {},
               {}, {}, paint);
}

AxisLanes general(int forward, int backward) {
  return {std::vector<LaneWish>(forward), std::vector<LaneWish>(backward)};
}

// The line right of a lane: is it dashed, and may traffic cross it to its left, to its right?
using Between = std::tuple<bool, bool, bool>;
Between line(const Lanes& made, int position) {
  for (const LaneSeparator& separator : made.separators)
    if (separator.position == position)
      return {separator.dashed, separator.leftwards, separator.rightwards};
  return {};
}
const Between for_all{true, true, true}, for_none{false, false, false},
    for_the_right{true, true, false}, for_the_left{true, false, true};

// Four lanes along the axis have the ordinalities 3, 1, 2, 4 from left to right.
TEST(LaneChange, ForbiddenBothWaysIsASolidLine) {
  const Lanes made = on_street(general(4, 0), {{}, {{1, 50, 1, 2, false}, {1, 50, 2, 1, false}}});
  EXPECT_EQ(line(made, 1), for_all);
  EXPECT_EQ(line(made, 2), for_none);
  EXPECT_EQ(line(made, 3), for_all);
}

TEST(LaneChange, ForbiddenOneWayIsASolidLineBesideADashedOne) {
  EXPECT_EQ(line(on_street(general(4, 0), {{}, {{1, 50, 1, 2, false}}}), 2), for_the_right);
  EXPECT_EQ(line(on_street(general(4, 0), {{}, {{1, 50, 2, 1, false}}}), 2), for_the_left);
}

TEST(LaneChange, OfTwoDecisionsTheLaterHolds) {
  EXPECT_EQ(line(on_street(general(4, 0), {{}, {{1, 50, 1, 2, false}, {1, 20, 1, 2, true}}}), 2),
            for_all);
}

TEST(LaneChange, DecidedElsewhereChangesNothing) {
  for (const LaneChange& change : {LaneChange{1, 100, 1, 2, false}, LaneChange{2, 50, 1, 2, false},
                                   LaneChange{1, 50, 3, 2, false}})
    EXPECT_EQ(line(on_street(general(4, 0), {{}, {change}}), 2), for_all);
}

TEST(LaneChange, AcrossTheMiddleIsNoChange) {
  const AxisLanes wanted = general(2, 2);
  const Lanes plain = on_street(wanted, {}),
              decided = on_street(wanted, {{}, {{1, 50, 1, 2, true}}});
  EXPECT_EQ(line(decided, 2), line(plain, 2));
}

TEST(LaneChange, IntoParkingIsAllowedByHandAlone) {
  AxisLanes wanted = general(2, 0);
  wanted.forward[1].kind = LaneKind::parking;
  EXPECT_EQ(line(on_street(wanted, {}), 1), (Between{true, false, false})) << "its paint stays";
  EXPECT_EQ(line(on_street(wanted, {{}, {{1, 50, 1, 2, true}}}), 1), for_the_left);
}

// What a source says of the lanes that drive, in their direction.
TEST(LaneChange, FollowsTheWordsOfItsSource) {
  const LeavingLane nowhere{false, false}, right{false, true};
  const Lanes made = on_street(
      general(3, 2), {{}, {}, {{1, {nowhere, right, std::nullopt}, {right, LeavingLane{}}}}});
  EXPECT_EQ(line(made, 1), for_all) << "against the axis, the one on the left is lane 2";
  EXPECT_EQ(line(made, 3), for_none);
  EXPECT_EQ(line(made, 4), for_all);
}

TEST(LaneChange, ByHandGoesBeforeTheSource) {
  const LeavingLane nowhere{false, false};
  EXPECT_EQ(
      line(on_street(general(2, 0), {{}, {{1, 50, 1, 2, true}}, {{1, {nowhere, nowhere}, {}}}}), 1),
      for_the_left);
}

TEST(LaneChange, AMixedLineIsTwoStripesAsFarApartAsTheyAreWide) {
  const Lanes made = on_street(general(2, 0), {{}, {{1, 50, 1, 2, false}}});
  ASSERT_EQ(made.separators.size(), 1u);
  const MultiPolygon paint = paint_of(made.separators[0]);
  ASSERT_GT(paint.size(), 2u);
  EXPECT_TRUE(Geos().valid(paint));
  double solid = 0, longest = 0;
  for (const Polygon& stripe : paint) {
    double low = 1e9, high = -1e9, west = 1e9, east = -1e9;
    for (const Point& p : stripe.front()) {
      low = std::min(low, p.y), high = std::max(high, p.y);
      west = std::min(west, p.x), east = std::max(east, p.x);
    }
    EXPECT_NEAR(std::abs(low + high) / 2, 0.1, 1e-9);
    if (east - west > longest) longest = east - west, solid = (low + high) / 2;
  }
  EXPECT_NEAR(longest, 100, 1e-9);
  EXPECT_NEAR(solid, 0.1, 1e-9) << "on the side of those who may not leave";
}

}  // namespace lane_change_test
}  // namespace streetgen
