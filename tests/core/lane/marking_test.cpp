#include "lane/marking.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "streetgen/streets.hpp"

namespace streetgen {
namespace marking_test {

// West, east and south of the origin.
Streets tee(int importance_of_south) {
  return streets({{1, {{-100, 0, 0}, {0, 0, 0}}, 0, 8, 8, 5, 3},
                  {2, {{0, 0, 0}, {100, 0, 0}}, 0, 8, 8, 5, 3},
                  {3, {{0, 0, 0}, {0, -100, 0}}, 0, 6, 6, 5, importance_of_south}},
                 {});
}

struct Lines {
  int stop = 0, yield = 0;
  bool operator==(const Lines& other) const { return stop == other.stop && yield == other.yield; }
};

const AxisLanes two_way{std::vector<LaneWish>(1), std::vector<LaneWish>(1)};

Lines lines_of(const Lanes& made) {
  Lines found;
  for (const Marking& marking : made.markings) {
    found.stop += marking.kind == MarkingKind::stop;
    found.yield += marking.kind == MarkingKind::yield;
  }
  return found;
}

Lines lines(int importance_of_south, std::optional<JunctionKind> by_hand,
            const std::vector<ControlPoint>& signs = {}) {
  PaintRules paint;
  if (by_hand) paint.junctions.push_back({3, {1, 1, 0}, *by_hand});
  return lines_of(lanes(tee(importance_of_south), {{1, two_way}, {2, two_way}, {3, two_way}}, {},
                        {}, signs, {}, paint));
}

const ControlPoint signals{3, 0, ControlKind::signals};
const ControlPoint stop_sign{3, 10, ControlKind::stop};
const ControlPoint yield_sign{3, 10, ControlKind::yield};

TEST(Marking, OfSignalsByHandStopsAllWhoCome) {
  EXPECT_EQ(lines(3, JunctionKind::signals), (Lines{3, 0}));
  EXPECT_EQ(lines(4, JunctionKind::signals), (Lines{3, 0}));
  EXPECT_EQ(lines(4, JunctionKind::signals, {yield_sign}), (Lines{2, 1})) << "beside the lights";
}

TEST(Marking, OfStopByHandStopsWhoIsLessImportant) {
  EXPECT_EQ(lines(4, std::nullopt), (Lines{0, 1}));
  EXPECT_EQ(lines(4, JunctionKind::stop), (Lines{1, 0}));
  EXPECT_EQ(lines(3, JunctionKind::stop), (Lines{3, 0})) << "all where none is more important";
  EXPECT_EQ(lines(3, JunctionKind::stop, {stop_sign}), (Lines{1, 0})) << "where its sign stands";
  EXPECT_EQ(lines(4, JunctionKind::stop, {yield_sign}), (Lines{0, 1}));
  EXPECT_EQ(lines(4, JunctionKind::stop, {signals}), (Lines{1, 0}));
}

TEST(Marking, OfPriorityByHandLetsWhoIsLessImportantYield) {
  EXPECT_EQ(lines(5, std::nullopt), (Lines{1, 0}));
  EXPECT_EQ(lines(5, JunctionKind::priority), (Lines{0, 1}));
  EXPECT_EQ(lines(3, JunctionKind::priority), (Lines{0, 1})) << "the stem, of equals";
  EXPECT_EQ(lines(3, JunctionKind::priority, {signals}), (Lines{0, 1}));
  EXPECT_EQ(lines(3, JunctionKind::right_before_left), (Lines{0, 0}));
  EXPECT_EQ(lines(5, JunctionKind::priority, {stop_sign}), (Lines{1, 0}));
}

TEST(Marking, LetsNobodyYieldToAStreetByWhichNobodyComes) {
  const AxisLanes away{std::vector<LaneWish>(1), {}}, towards{{}, std::vector<LaneWish>(1)};
  const auto waits = [&](const AxisLanes& of_south) {
    return lines_of(lanes(tee(2), {{1, two_way}, {2, two_way}, {3, of_south}}, {}, {}));
  };
  EXPECT_EQ(waits(away), (Lines{0, 0}));
  EXPECT_EQ(waits(towards), (Lines{0, 2}));
}

TEST(Marking, OfRightBeforeLeftByHandIsNone) {
  EXPECT_EQ(lines(5, JunctionKind::right_before_left), (Lines{0, 0}));
  EXPECT_EQ(lines(5, JunctionKind::right_before_left, {signals}), (Lines{0, 0}));
}

TEST(Marking, OfAnotherKindByHandFollowsClassesAndPoints) {
  EXPECT_EQ(lines(4, JunctionKind::ramp), (Lines{0, 1}));
  EXPECT_EQ(lines(4, JunctionKind::roundabout, {signals}), (Lines{3, 0}));
}

}  // namespace marking_test
}  // namespace streetgen
