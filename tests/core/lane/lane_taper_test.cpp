#include "lane/lane_taper.hpp"

#include <gtest/gtest.h>

namespace streetgen {
namespace lane_taper_test {

using Indices = std::vector<int>;

// Lanes along the edge but for the first ones, which come against it.
std::vector<LaneWish> lanes(int against, int along) {
  std::vector<LaneWish> all(against + along);
  for (int i = 0; i < against; ++i) all[i].along_axis = false;
  return all;
}

// The edge ends at the node where the other one, with as many places for lanes, begins.
ChangingLanes ahead(const std::vector<LaneWish>& here, const std::vector<LaneWish>& there,
                    DrivingSide side = DrivingSide::right) {
  return changing_lanes({here, false}, {there, true}, side);
}

TEST(LaneTaper, EndsTheOuterLane) {
  EXPECT_EQ(ahead(lanes(0, 3), lanes(0, 2)).ending, (Indices{2}));
  EXPECT_EQ(ahead(lanes(0, 3), lanes(0, 2), DrivingSide::left).ending, (Indices{0}));
  EXPECT_EQ(ahead(lanes(1, 2), lanes(1, 1)).ending, (Indices{2}));
  EXPECT_EQ(ahead(lanes(2, 1), lanes(1, 1)).ending, (Indices{0})) << "the other direction begins";
  EXPECT_EQ(ahead(lanes(2, 2), lanes(1, 1)).ending, (Indices{0, 3}));
  EXPECT_TRUE(ahead(lanes(1, 2), lanes(1, 2)).ending.empty());
}

TEST(LaneTaper, EndsTheLaneThatIsMarkedToLeave) {
  std::vector<LaneWish> marked = lanes(0, 3);
  marked[0].turns = turn::left;
  EXPECT_EQ(ahead(marked, lanes(0, 2)).ending, (Indices{0}));
  marked[2].turns = turn::merge_left;
  EXPECT_EQ(ahead(marked, lanes(0, 2)).ending, (Indices{2}));
  EXPECT_EQ(ahead(marked, lanes(0, 1)).ending, (Indices{0, 2}));
  marked[0].turns = turn::left | turn::through;
  EXPECT_EQ(ahead(marked, lanes(0, 1)).ending, (Indices{1, 2}));
}

TEST(LaneTaper, BeginsBesideTheLanesThatGoOn) {
  std::vector<LaneWish> pocket = lanes(1, 2);
  EXPECT_EQ(ahead(lanes(1, 1), pocket).beside, (Indices{1}));
  EXPECT_TRUE(ahead(lanes(1, 1), pocket).ending.empty());
  EXPECT_EQ(ahead(lanes(0, 2), lanes(0, 3)).beside, (Indices{1}));
  std::vector<LaneWish> left_turn = lanes(0, 3);
  left_turn[0].turns = turn::left;
  EXPECT_EQ(ahead(lanes(0, 2), left_turn).beside, (Indices{0}));
}

TEST(LaneTaper, CountsKindsApart) {
  std::vector<LaneWish> parking = lanes(0, 2);
  parking[1].kind = LaneKind::parking;
  EXPECT_EQ(ahead(parking, lanes(0, 1)).ending, (Indices{1}));
  const ChangingLanes swapped = ahead(parking, lanes(0, 2));
  EXPECT_EQ(swapped.ending, (Indices{1}));
  EXPECT_EQ(swapped.beside, (Indices{0}));
  std::vector<LaneWish> bus = lanes(0, 2);
  bus[1].kind = LaneKind::bus;
  EXPECT_TRUE(ahead(bus, lanes(0, 2)).ending.empty()) << "a bus lane goes on as a general one";
}

// 100 m, 9 m wide; the last 20 m lose 1 m on either side.
LaneStrip narrowing() {
  LaneStrip strip{{{0, 0, 0}, {100, 0, 0}}, 4.5, 4.5, 5, 95, {}, {}};
  strip.profile.places = {{0, 4.5, 4.5}, {75, 4.5, 4.5}, {95, 3.5, 3.5}, {100, 4.5, 4.5}};
  strip.from_border = {{5, 4.5, 0}, {5, -4.5, 0}};
  strip.to_border = {{95, 3.5, 0}, {95, -3.5, 0}};
  return strip;
}

TEST(LaneTaper, LeavesTheOthersTheirWidth) {
  const LaneStrip strip = narrowing();
  TaperedLanes tapered;
  tapered.end.ending = {2};
  const std::vector<LaneShares> shares = tapered_shares(strip, {0, 1. / 3, 2. / 3, 1}, tapered);
  ASSERT_EQ(shares.size(), 4u);
  for (const double at : {40., 75., 85., 95.}) {
    std::vector<double> offsets;
    for (const LaneShares& border : shares) offsets.push_back(strip.offset_at(at, border));
    const double lost = at <= 75 ? 0 : 2 * (at - 75) / 20;
    const double tolerance = at == 85 ? 0.1 : 1e-9;  // shares are linear between places
    EXPECT_NEAR(offsets[0] - offsets[1], 3, tolerance) << at;
    EXPECT_NEAR(offsets[1] - offsets[2], 3, tolerance) << at;
    EXPECT_NEAR(offsets[2] - offsets[3], 3 - lost, tolerance) << at;
  }
}

TEST(LaneTaper, IsTakenByGroundBesideTheLanesFirst) {
  LaneStrip strip = narrowing();
  const std::vector<double> own{1. / 9, 4. / 9, 8. / 9};
  const auto offsets_at = [&](double at) {
    std::vector<double> offsets;
    for (const LaneShares& border : tapered_shares(strip, own, {}))
      offsets.push_back(strip.offset_at(at, border));
    return offsets;
  };
  const auto are = [&](double at, const std::vector<double>& wanted) {
    const std::vector<double> offsets = offsets_at(at);
    for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(offsets[i], wanted[i], 1e-9) << at;
  };
  are(40, {3.5, 0.5, -3.5});
  are(95, {3.5, 0.5, -3.5});
  strip.profile.places[2] = {95, 4, 3};
  // At the right kerb 1.5 m are lost, of which 1 m lay beside the lanes: all share the rest.
  are(95, {4 - 0.5 * 7 / 7.5, 4 - 3.5 * 7 / 7.5, -3});
}

TEST(LaneTaper, TakesNoMoreThanALaneHas) {
  LaneStrip strip = narrowing();
  strip.profile.places[2] = {95, 1, 1};
  TaperedLanes tapered;
  tapered.end.ending = {2};
  const std::vector<LaneShares> shares = tapered_shares(strip, {0, 1. / 3, 2. / 3, 1}, tapered);
  EXPECT_NEAR(strip.share_at(95, shares[2]), 1, 1e-12) << "it is gone";
  EXPECT_NEAR(strip.share_at(95, shares[1]), 0.5, 1e-12) << "the others share what is left";
}

TEST(LaneTaper, IsSharedByAllWhereNoLaneChanges) {
  const LaneStrip strip = narrowing();
  for (const LaneShares& border : tapered_shares(strip, {0, 0.25, 1}, {}))
    for (const double share : border) EXPECT_NEAR(share, border.front(), 1e-12);
}

// Of three lanes that change the one in the middle lies on neither side, whatever rounding says.
TEST(LaneTaper, LeavesTheMiddleLaneToNoSide) {
  LaneStrip strip = narrowing();
  strip.profile.places[2] = {95, 4, 3};
  TaperedLanes tapered;
  tapered.end.ending = {0, 1, 2};
  for (const double noise : {-1e-15, 0.0, 1e-15}) {
    const std::vector<LaneShares> shares =
        tapered_shares(strip, {0, 1. / 3, 2. / 3 + noise, 1}, tapered);
    EXPECT_NEAR(strip.share_at(95, shares[1]), 2.5 / 7, 1e-9) << noise;
    EXPECT_NEAR(strip.share_at(95, shares[2]), 5.5 / 7, 1e-9) << noise;
  }
}

}  // namespace lane_taper_test
}  // namespace streetgen
