#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "rounds.hpp"
#include "simulation/made_network.hpp"
#include "streetgen/error.hpp"
#include "streetgen/traffic.hpp"

namespace streetgen {
namespace simulation_test {

TEST(LinkPlaces, TellBothDirectionsAndStoreysApart) {
  NetworkMaker maker;
  const int there = maker.lane(200), back = maker.lane(200), bridge = maker.lane(200);
  maker.piece(there, {0, 0, 0, 0, 0});
  maker.piece(back, {0, 200, 0, M_PI, 0});
  maker.piece(bridge, {0, 100, -100, M_PI / 2, 0});
  maker.opposite(there, back);
  TrafficNetwork network = maker.network();
  network.heights = {};
  network.heights.end_owner();
  network.heights.end_owner();
  network.heights.add({0, 6});
  network.heights.end_owner();
  const LinkPlaces places(network);
  LocatedPlace found = places.locate(50, 1, 10);
  EXPECT_EQ(found.place.link, there) << "the smallest key";
  EXPECT_DOUBLE_EQ(found.place.metres, 50);
  EXPECT_DOUBLE_EQ(found.offset, 1);
  found = places.locate(50, 1, 10, M_PI - 0.1);
  EXPECT_EQ(found.place.link, back);
  EXPECT_DOUBLE_EQ(found.place.metres, 150);
  EXPECT_NEAR(found.offset, -1, 1e-9);
  EXPECT_EQ(places.locate(99, 0.5, 10).place.link, there);
  EXPECT_EQ(places.locate(99, 0.5, 10, {}, 5).place.link, bridge);
  EXPECT_EQ(places.locate(99, 0.5, 10, M_PI / 2).place.link, bridge);
  EXPECT_EQ(places.locate(99, 0.5, 10, M_PI / 2, 1).place.link, there);
  EXPECT_EQ(places.locate(50, 20, 10).place.link, -1);
  EXPECT_EQ(places.locate(50, 20, 20).place.link, there);
  EXPECT_EQ(places.locate(5000, 0, 1e6).place.link, there) << "far off, from its end";
  EXPECT_THROW(places.locate(std::numeric_limits<double>::quiet_NaN(), 0, 1), Error);
  EXPECT_THROW(places.locate(0, 0, -1), Error);
  EXPECT_EQ(LinkPlaces(TrafficNetwork{}).locate(0, 0, 10).place.link, -1);
}

TEST(LinkPlaces, FindTheNearestOfAllPlaces) {
  std::mt19937_64 random(8);
  const auto real = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int round = 0; round < rounds(20); ++round) {
    NetworkMaker maker;
    for (int i = 0; i < 40; ++i) {
      const int link = maker.lane(real(1, 120));
      maker.link(link).width = 0.001F;
      maker.piece(link, {0, real(-200, 200), real(-200, 200), real(-4, 4),
                         i % 3 == 0 ? 0 : 1 / real(5, 200) * (i % 2 ? 1 : -1)});
      const double half = maker.link(link).length / 2;
      const LinkFrame at = frame(maker.network(), {link, half});
      maker.piece(link, {half, at.x, at.y, at.heading, i % 5 == 0 ? 0 : real(-0.1, 0.1)});
    }
    const TrafficNetwork network = maker.network();
    const LinkPlaces places(network);
    for (int k = 0; k < 50; ++k) {
      const double x = real(-250, 250), y = real(-250, 250);
      double nearest = 1e9;
      for (int link = 0; link < network.size(); ++link)
        for (double s = 0; s <= network.links[link].length; s += 0.5) {
          const LinkFrame at = frame(network, {link, s});
          nearest = std::min(nearest, std::hypot(at.x - x, at.y - y));
        }
      const LocatedPlace found = places.locate(x, y, 1000);
      ASSERT_GE(found.place.link, 0);
      const LinkFrame at = frame(network, found.place);
      const double distance = std::hypot(at.x - x, at.y - y);
      EXPECT_LE(distance, nearest + 1e-9);
      EXPECT_LE(std::abs(found.offset), distance + 1e-9);
      EXPECT_EQ(places.locate(x, y, distance - 0.001).place.link, -1);
      EXPECT_EQ(places.locate(x, y, distance + 0.001).place.link, found.place.link);
    }
  }
}

// A place on a link is found again, with its offset.
TEST(LinkPlaces, FindAPlaceAgain) {
  NetworkMaker maker;
  const int link = maker.lane(60);
  maker.piece(link, {0, 10, 20, 1, 0});
  maker.piece(link, {20, 10 + 20 * std::cos(1), 20 + 20 * std::sin(1), 1, -1 / 25.0});
  const TrafficNetwork network = maker.network();
  const LinkPlaces places(network);
  for (double s = 0; s <= 60; s += 0.7)
    for (const double offset : {-1.5, 0.0, 1.5}) {
      const LinkFrame at = frame(network, {link, s});
      const LocatedPlace found = places.locate(at.x - offset * std::sin(at.heading),
                                               at.y + offset * std::cos(at.heading), 5);
      EXPECT_NEAR(found.place.metres, s, 1e-9);
      EXPECT_NEAR(found.offset, offset, 1e-9);
    }
}

}  // namespace simulation_test
}  // namespace streetgen
