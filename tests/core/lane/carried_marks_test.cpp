// Turn marks beyond nodes at which a street goes on alone.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "geometry/polyline.hpp"
#include "interconnection/joined_town.hpp"

namespace streetgen {
namespace carried_marks_test {

using Marks = std::vector<unsigned>;
constexpr unsigned left = turn::left, through = turn::through, right = turn::right;

LanedAxis marked(LanedAxis axis, const Marks& marks) {
  for (std::size_t i = 0; i < marks.size(); ++i) axis.forward[i].turns = marks[i];
  return axis;
}

// The marks on the lanes along the axis, or against it, from left to right as one drives.
Marks marks_on(const JoinedTown& town, std::int64_t axis, bool along = true) {
  Marks found;
  for (int i = 0; i < town.lane_count(); ++i)
    if (town.axis_of(i) == axis && town.lane(i).along_axis == along && !town.lane(i).both_ways)
      found.push_back(town.lane(i).turns);
  if (!along) std::reverse(found.begin(), found.end());
  return found;
}

const Line first{{-100, 0, 0}, {-20, 0, 0}}, next{{-20, 0, 0}, {0, 0, 0}};

Marks carried(const LanedAxis& from, const LanedAxis& to) {
  return marks_on(JoinedTown({from, to}), to.id);
}

TEST(CarriedMarks, HoldToTheJunction) {
  const JoinedTown town({marked(road(1, first, 3, 0), {left, through, through | right}),
                         road(2, next, 3, 0), road(3, {{0, 0, 0}, {100, 0, 0}}, 3, 1),
                         road(4, north, 1, 1), road(5, south, 1, 1)});
  EXPECT_EQ(marks_on(town, 2), (Marks{left, through, through | right}));
  EXPECT_EQ(marks_on(town, 3), (Marks{0, 0, 0}));
  const auto all = town.join();
  EXPECT_EQ(plausible(town, all, 2, 4), (Ranks{{1, 1}}));
  EXPECT_EQ(plausible(town, all, 2, 3).count({1, 1}), 0u);
  EXPECT_EQ(plausible(town, all, 2, 5), (Ranks{{3, 1}}));
}

TEST(CarriedMarks, GoOnOverManyEdgesHoweverTheseAreDrawn) {
  LanedAxis against = road(2, {{0, 0, 0}, {-20, 0, 0}}, 0, 2);
  const JoinedTown town({marked(road(1, first, 2, 0), {left, through}), against,
                         road(3, {{0, 0, 0}, {20, 0, 0}}, 2, 0),
                         road(4, {{20, 0, 0}, {40, 5, 0}}, 2, 1)});
  EXPECT_EQ(marks_on(town, 2, false), (Marks{left, through}));
  EXPECT_EQ(marks_on(town, 3), (Marks{left, through}));
  EXPECT_EQ(marks_on(town, 4), (Marks{left, through}));
  EXPECT_EQ(marks_on(town, 4, false), (Marks{0}));
}

TEST(CarriedMarks, EndWhereTheStreetHasMarksOfItsOwn) {
  EXPECT_EQ(carried(marked(road(1, first, 2, 0), {left, through}),
                    marked(road(2, next, 2, 0), {0, right})),
            (Marks{0, right}));
}

TEST(CarriedMarks, ALaneThatBeginsTakesTheTurnToItsSide) {
  const LanedAxis two = marked(road(1, first, 2, 0), {through, through | right});
  EXPECT_EQ(carried(two, road(2, next, 3, 0)), (Marks{through, through, right}));
  LanedAxis wide = road(2, next, 3, 0);
  wide.offset = 1.75;
  EXPECT_EQ(carried(marked(road(1, first, 2, 0), {left | through, through}), wide),
            (Marks{left, through, through}));
  EXPECT_EQ(carried(marked(road(1, first, 2, 0), {left, right}), road(2, next, 3, 0)),
            (Marks{left, right, right}));
  EXPECT_EQ(carried(marked(road(1, first, 2, 0), {left, through}), road(2, next, 3, 0)),
            (Marks{left, through, 0}));
}

TEST(CarriedMarks, AMarkToMergeEndsWithItsLane) {
  const LanedAxis three =
      marked(road(1, first, 3, 0), {left, through, turn::merge_left});
  EXPECT_EQ(carried(three, road(2, next, 2, 0)), (Marks{left, through}));
  EXPECT_EQ(carried(three, road(2, next, 3, 0)), (Marks{left, through, turn::merge_left}));
}

TEST(CarriedMarks, LanesThatBecomeOneBearBoth) {
  EXPECT_EQ(carried(marked(road(1, first, 3, 0), {left, 0, right}), road(2, next, 2, 0)),
            (Marks{left, through | right}));
}

// The left turn lies behind the first carriageway, whose traffic comes from the left.
class CarriedOver : public testing::Test {
 protected:
  static constexpr double apart = 18;
  static JoinedTown town(const Marks& marks) {
    const auto lanes = static_cast<int>(marks.size());
    return JoinedTown(
        {marked(road(1, west, lanes, 0), marks), road(2, {{0, 0, 0}, {apart, 0, 0}}, 2, 0),
         road(3, {{apart, 0, 0}, {140, 0, 0}}, 2, 0), road(4, {{0, 100, 0}, {0, 0, 0}}, 1, 0),
         road(5, {{0, 0, 0}, {0, -100, 0}}, 1, 0), road(6, {{apart, -100, 0}, {apart, 0, 0}}, 1, 0),
         road(7, {{apart, 0, 0}, {apart, 100, 0}}, 1, 0)});
  }
};

TEST_F(CarriedOver, ATurnThatNoWayAnswersIsMeantForTheNextNode) {
  const JoinedTown crossing = town({left, through, right});
  EXPECT_EQ(marks_on(crossing, 2), (Marks{left, through}));
  EXPECT_EQ(marks_on(crossing, 3), (Marks{0, 0}));
  const auto all = crossing.join();
  EXPECT_EQ(plausible(crossing, all, 1, 5), (Ranks{{3, 1}}));
  EXPECT_EQ(plausible(crossing, all, 1, 2), (Ranks{{1, 1}, {2, 2}}));
  EXPECT_EQ(plausible(crossing, all, 2, 7), (Ranks{{1, 1}}));
  EXPECT_EQ(plausible(crossing, all, 2, 3).count({1, 1}), 0u);
}

TEST_F(CarriedOver, WhoMayGoStraightOnTooStillMay) {
  EXPECT_EQ(marks_on(town({left | through, through | right}), 2), (Marks{left | through, through}));
}

TEST_F(CarriedOver, MarksThatAreAllAnsweredEnd) {
  EXPECT_EQ(marks_on(town({through, through | right}), 2), (Marks{0, 0}));
}

// Without a first edge.
TEST(CarriedMarks, OfARingStayOnTheirEdge) {
  const Line upper{{0, 0, 0}, {50, 60, 0}, {100, 0, 0}}, lower{{100, 0, 0}, {50, -60, 0}, {0, 0, 0}};
  const JoinedTown bare({road(1, upper, 1, 0), road(2, lower, 1, 0)});
  EXPECT_EQ(marks_on(bare, 2), (Marks{0}));
  const JoinedTown ring({marked(road(1, upper, 1, 0), {left}), road(2, lower, 1, 0)});
  EXPECT_EQ(marks_on(ring, 2), (Marks{left}));
}

}  // namespace carried_marks_test
}  // namespace streetgen
