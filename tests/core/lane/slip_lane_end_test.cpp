// Slip lanes wait where they end at a street.
#include <gtest/gtest.h>

#include "streetgen/lane.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {
namespace slip_lane_end_test {

struct Town {
  int lanes_behind = 1;  // of the street to the east, behind the end of the slip lane
  int importance = 4;    // of the slip lane
  double towards = 30;   // metres from the corner to both ends of the slip lane
  bool one_way = true;   // the slip lane
};

// A street from west to east, one that comes from the south, and a lane that cuts the corner.
std::vector<Marking> lines_across(const Town& town) {
  const double s = town.towards;
  std::vector<StreetAxis> axes{{1, {{-100, 0, 0}, {0, 0, 0}}, 0, 7, 7, 6, 4},
                               {2, {{0, 0, 0}, {s, 0, 0}}, 0, 7, 7, 6, 4},
                               {3, {{s, 0, 0}, {150, 0, 0}}, 0, 7, 7, 6, 4},
                               {4, {{0, -150, 0}, {0, -s, 0}}, 0, 7, 7, 6, 4},
                               {5, {{0, -s, 0}, {0, 0, 0}}, 0, 7, 7, 6, 4},
                               {6, {{0, -s, 0}, {s, 0, 0}}, 0, 4, 4, 6, town.importance}};
  axes[5].leads_backward = !town.one_way;
  const AxisLanes both{std::vector<LaneWish>(1), std::vector<LaneWish>(1)};
  const AxisLanes behind{std::vector<LaneWish>(town.lanes_behind), std::vector<LaneWish>(1)};
  const AxisLanes slip{std::vector<LaneWish>(1), std::vector<LaneWish>(town.one_way ? 0 : 1)};
  std::vector<Marking> lines;
  for (const Marking& marking :
       lanes(streets(axes, {}),
             {{1, both}, {2, both}, {3, behind}, {4, both}, {5, both}, {6, slip}}, {}, {})
           .markings)
    if (marking.kind != MarkingKind::arrow) lines.push_back(marking);
  return lines;
}

TEST(SlipLaneEnd, HasAYieldLine) {
  const std::vector<Marking> lines = lines_across({});
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].kind, MarkingKind::yield);
  // Before the roadway of the street that it comes to, 3.5 m from its axis.
  for (const Point& end : lines[0].line) EXPECT_LT(end.y, -3.5);
  EXPECT_GT(lines[0].line.front().x, 15);
}

// Nobody on the street waits for it, however important it is called.
TEST(SlipLaneEnd, GoesNotFirst) {
  const std::vector<Marking> lines = lines_across({1, 3});
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_GT(lines[0].line.front().x, 15);
  EXPECT_LT(lines[0].line.front().y, -3.5);
}

TEST(SlipLaneEnd, IsFreeOntoALaneOfItsOwn) { EXPECT_TRUE(lines_across({2}).empty()); }

// A block is between, or traffic of both directions takes it.
TEST(SlipLaneEnd, LiesBesideAnIsland) {
  EXPECT_TRUE(lines_across({1, 4, 90}).empty());
  EXPECT_TRUE(lines_across({1, 4, 30, false}).empty());
}

}  // namespace slip_lane_end_test
}  // namespace streetgen
