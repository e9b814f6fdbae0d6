#include <gtest/gtest.h>

#include <cmath>

#include "simulation/made_network.hpp"
#include "streetgen/error.hpp"
#include "streetgen/traffic.hpp"

namespace streetgen {
namespace simulation_test {

TEST(LinkFrame, GoesAlongLinesAndArcs) {
  NetworkMaker maker;
  const double quarter = 20 * M_PI / 2;
  const int link = maker.lane(10 + quarter);
  maker.piece(link, {0, 100, 200, 0, 0});
  maker.piece(link, {10, 110, 200, 0, 1 / 20.0});
  TrafficNetwork network = maker.network();
  network.heights = {};
  network.heights.add({0, 5});
  network.heights.add({10, 6});
  network.heights.end_owner();
  LinkFrame at = frame(network, {link, 4});
  EXPECT_DOUBLE_EQ(at.x, 104);
  EXPECT_DOUBLE_EQ(at.y, 200);
  EXPECT_DOUBLE_EQ(at.height, 5.4);
  EXPECT_NEAR(at.grade, 0.1, 1e-12);
  EXPECT_EQ(at.steering, 0);
  at = frame(network, {link, 1000}, 2.7);
  EXPECT_NEAR(at.x, 130, 1e-9);
  EXPECT_NEAR(at.y, 220, 1e-9);
  EXPECT_NEAR(at.heading, M_PI / 2, 1e-12);
  EXPECT_DOUBLE_EQ(at.height, 6);
  EXPECT_NEAR(std::tan(at.steering), 2.7 / 20, 1e-12);
  EXPECT_THROW(frame(network, {7, 0}), Error);
}

TEST(LinkFrame, KeepsItsDistanceFromTheCentreOfAnArc) {
  for (const double curvature : {0.2, -0.05, 1e-4, -1e-9, 1e-13}) {
    NetworkMaker maker;
    const int link = maker.lane(12);
    maker.piece(link, {0, 0, 0, 3, curvature});
    const TrafficNetwork network = maker.network();
    LinkFrame before = frame(network, {link, 0});
    for (double s = 0.05; s <= 12; s += 0.05) {
      const LinkFrame at = frame(network, {link, s});
      const double chord = std::hypot(at.x - before.x, at.y - before.y);
      const double half = curvature * 0.05 / 2;
      EXPECT_NEAR(chord, half == 0 ? 0.05 : 0.05 * std::sin(half) / half, 1e-9);
      EXPECT_NEAR(std::remainder(at.heading - before.heading, 2 * M_PI), 2 * half, 1e-9);
      before = at;
    }
  }
}

// A street to the east, a bend of 90 degrees to the left, and a street to the north.
TEST(BodyFrame, HeadsFromTheRearToTheFrontOverTheLinksOfACar) {
  NetworkMaker maker;
  const double bend = 8 * M_PI / 2;
  const int east = maker.lane(50), north = maker.lane(50);
  const int turn = maker.movement(east, north, bend);
  maker.piece(east, {0, 0, 0, 0, 0});
  maker.piece(north, {0, 58, 8, M_PI / 2, 0});
  maker.piece(turn, {0, 50, 0, 0, 1 / 8.0});
  const TrafficNetwork network = maker.network();
  Traffic traffic(network);
  Car car;
  const auto heading_at = [&](int link, double metres, float length) {
    car.place = {link, metres};
    car.length = length;
    const int index = traffic.add(car);
    const LinkFrame frame = body_frame(traffic, index);
    traffic.remove(index);
    return frame.heading;
  };
  EXPECT_NEAR(heading_at(east, 30, 5), 0, 1e-12);
  EXPECT_NEAR(heading_at(north, 20, 5), M_PI / 2, 1e-12);
  // A chord of an arc turns by half of what its front does.
  EXPECT_NEAR(heading_at(turn, 8, 5), (8 + 3) / 8.0 / 2, 1e-9);
  // The rear of a bus is on the street to the east yet, or behind the whole bend.
  EXPECT_NEAR(heading_at(turn, 4, 10), std::atan2(8 - 8 * std::cos(0.5), 6 + 8 * std::sin(0.5)),
              1e-9);
  EXPECT_NEAR(heading_at(north, 2, static_cast<float>(bend + 5)), std::atan2(10, 11), 1e-6);
  // It stands straight on where nothing is known behind.
  EXPECT_NEAR(heading_at(east, 2, 12), 0, 1e-12);
}

TEST(Beside, GoesThereAndBack) {
  NetworkMaker maker;
  const int right = maker.lane(100), left = maker.lane(90), towards = maker.lane(100);
  maker.beside(right, {left, true, true, false, 10, 40, 0, 32});
  maker.beside(right, {left, true, false, false, 40, 100, 32, 90});
  maker.beside(left, {right, false, true, false, 0, 32, 10, 40});
  maker.beside(left, {right, false, true, false, 32, 90, 40, 100});
  maker.beside(left, {towards, true, false, true, 0, 90, 95, 5});
  const TrafficNetwork network = maker.network();
  EXPECT_EQ(beside(network, {right, 9}, true).place.link, -1);
  EXPECT_EQ(beside(network, {right, 50}, false).place.link, -1);
  for (double s = 10; s <= 100; s += 0.5) {
    const NeighbourPlace there = beside(network, {right, s}, true);
    ASSERT_EQ(there.place.link, left);
    EXPECT_EQ(there.may_change, s <= 40);
    const NeighbourPlace back = beside(network, there.place, false);
    ASSERT_EQ(back.place.link, right);
    EXPECT_NEAR(back.place.metres, s, 1e-9);
  }
  const NeighbourPlace opposite = beside(network, {left, 30}, true);
  EXPECT_TRUE(opposite.opposite);
  EXPECT_DOUBLE_EQ(opposite.place.metres, 65);
}

TEST(SignalAspect, ComesAgainEachCycle) {
  NetworkMaker maker;
  const int lane = maker.lane(10), movement = maker.movement(lane, maker.lane(10), 5);
  maker.plans = {{1, 60, 15}};
  maker.signal(movement, 0, {{5, Aspect::red}, {30, Aspect::permitted}, {50, Aspect::amber}});
  const TrafficNetwork network = maker.network();
  EXPECT_EQ(aspect_at(network, lane, 3), Aspect::none);
  for (const double cycle : {-600.0, -60.0, 0.0, 60.0, 6000.0}) {
    EXPECT_EQ(aspect_at(network, movement, cycle + 15), Aspect::amber) << "of the cycle before";
    EXPECT_EQ(aspect_at(network, movement, cycle + 20), Aspect::red);
    EXPECT_EQ(aspect_at(network, movement, cycle + 44.9), Aspect::red);
    EXPECT_EQ(aspect_at(network, movement, cycle + 45), Aspect::permitted);
    EXPECT_EQ(aspect_at(network, movement, cycle + 74), Aspect::amber);
  }
}

TEST(RowsOf, AreNoneOfAnOwnerBeyondTheLast) {
  RowsOf<int> rows;
  EXPECT_TRUE(rows.of(0).empty());
  rows.add(7);
  rows.end_owner();
  rows.end_owner();
  EXPECT_EQ(rows.of(0).size(), 1);
  EXPECT_EQ(rows.of(0)[0], 7);
  EXPECT_TRUE(rows.of(1).empty());
  EXPECT_TRUE(rows.of(2).empty());
}

TEST(LinkOf, FindsKeys) {
  NetworkMaker maker;
  for (int i = 0; i < 100; ++i) maker.lane(1);
  const TrafficNetwork network = maker.network();
  for (int i = 0; i < 100; ++i) EXPECT_EQ(link_of(network, 10 * i + 10), i);
  for (const std::int64_t none : {-5, 0, 15, 1010}) EXPECT_EQ(link_of(network, none), -1);
}

}  // namespace simulation_test
}  // namespace streetgen
