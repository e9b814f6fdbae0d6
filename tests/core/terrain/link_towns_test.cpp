#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "geometry/polyline.hpp"
#include "made_terrain.hpp"
#include "streetgen/error.hpp"
#include "streetgen/road_network.hpp"
#include "support/disjoint_sets.hpp"

namespace streetgen {
namespace {

// The district capitals of mainland Portugal: longitude, latitude, thousands of people.
constexpr double capitals[18][3] = {
    {-8.653, 40.640, 73},  {-7.865, 38.015, 36},  {-8.4265, 41.5503, 164}, {-6.757, 41.806, 35},
    {-7.493, 39.822, 56},  {-8.419, 40.205, 148}, {-7.909, 38.571, 57},    {-7.935, 37.019, 58},
    {-7.268, 40.537, 44},  {-8.807, 39.744, 120}, {-9.139, 38.722, 565},   {-7.428, 39.297, 26},
    {-8.611, 41.150, 263}, {-8.683, 39.236, 64},  {-8.893, 38.524, 114},   {-8.834, 41.694, 89},
    {-7.746, 41.301, 50},  {-7.911, 40.657, 93}};

std::vector<Town> portugal() {
  const double degree = 6371000 * M_PI / 180;
  std::vector<Town> towns;
  for (const auto& c : capitals)
    towns.push_back({TownKind::city,
                     c[2] * 1000,
                     {c[0] * degree * std::cos(39.7 * M_PI / 180), c[1] * degree, 0}});
  return towns;
}

TEST(LinkTowns, TheCapitalsOfPortugalGetTheNetworkOfThePaper) {
  const std::vector<Town> towns = portugal();
  const std::vector<TownLink> links = link_towns(towns, {});
  double sum = 0;
  for (const TownLink& link : links) sum += link.length;
  EXPECT_EQ(link_crossings(towns, links).size(), 12u);
  EXPECT_NEAR(sum, 3719.2, 0.03 * 3719.2);
}

TEST(LinkTowns, TheOrderOfTheTownsDoesNotMatter) {
  std::vector<Town> towns = portugal();
  std::vector<std::size_t> order(towns.size());
  std::iota(order.begin(), order.end(), 0);
  const auto lengths = [](const std::vector<TownLink>& links) {
    std::vector<double> all;
    for (const TownLink& link : links) all.push_back(std::round(link.length * 1e6));
    std::sort(all.begin(), all.end());
    return all;
  };
  const auto expected = lengths(link_towns(towns, {}));
  std::mt19937 random(1);
  for (int round = 0; round < 5; ++round) {
    std::shuffle(towns.begin(), towns.end(), random);
    EXPECT_EQ(lengths(link_towns(towns, {})), expected);
  }
}

TEST(LinkTowns, ALevelStaysConnectedAndEachLinkIsWorthItsCost) {
  const Terrain flat = made_terrain([](double, double) { return 10.0; }, 240);
  const MultiPolygon area{{{{0, 0}, {6000, 0}, {6000, 6000}, {0, 6000}, {0, 0}}}};
  for (LinkBenefit benefit : {LinkBenefit::of_ends, LinkBenefit::of_network}) {
    TownWish wish;
    wish.count = 30, wish.cities = 8, wish.towns = 10, wish.seed = 4, wish.largest = 5000;
    const std::vector<Town> towns = rank_size_towns(area, flat, {}, wish, {});
    ASSERT_EQ(towns.size(), 30u);
    NetworkWish network;
    network.benefit = benefit;
    const std::vector<TownLink> links = link_towns(towns, network);
    Groups sets(static_cast<int>(towns.size()));
    for (const TownLink& link : links) {
      sets.join(static_cast<int>(link.a), static_cast<int>(link.b));
      EXPECT_GE(link.benefit, link.cost);
    }
    for (std::size_t i = 1; i < towns.size(); ++i) EXPECT_EQ(sets.of(static_cast<int>(i)), 0);
  }
}

TEST(LinkTowns, LinksByHandStayAndRejectedOnesNeverCome) {
  const std::vector<Town> towns = portugal();
  NetworkWish wish;
  wish.by_hand = {{1, 3, RoadNetwork::highway, 0, 0, 0, 0, true}};
  const TownLink first = link_towns(towns, {}).front();
  wish.rejected = {{first.a, first.b}};
  const std::vector<TownLink> links = link_towns(towns, wish);
  const auto has = [&](std::size_t a, std::size_t b) {
    return std::any_of(links.begin(), links.end(), [&](const TownLink& link) {
      return std::minmax(link.a, link.b) == std::minmax(a, b);
    });
  };
  EXPECT_TRUE(has(1, 3));
  EXPECT_FALSE(has(first.a, first.b));
}

TEST(LinkTowns, TownsAtOnePlaceAndTooManyAreRefused) {
  std::vector<Town> towns = portugal();
  towns.push_back(towns.front());
  EXPECT_THROW(link_towns(towns, {}), Error);
  towns.assign(10000, {});
  EXPECT_THROW(link_towns(towns, {}), Error);
}

TEST(RankSizeTowns, TheyKeepOffWaterAndSteepGround) {
  const Terrain ground =
      made_terrain([](double x, double) { return x < 3000 ? 0.0 : (x - 3000) * 0.4; });
  const ZoneGrid water({rectangle_zone(0, 0, 3000, 3000, 0)}, {{0, Passage::bridge}}, 20);
  const MultiPolygon area{{{{0, 0}, {6000, 0}, {6000, 6000}, {0, 6000}, {0, 0}}}};
  TownWish wish;
  wish.count = 20, wish.cities = 3, wish.towns = 5, wish.seed = 9;
  const std::vector<Town> towns = rank_size_towns(area, ground, water, wish, {});
  EXPECT_EQ(towns.size(), 20u);
  for (std::size_t i = 0; i < towns.size(); ++i) {
    EXPECT_LT(towns[i].point.x, 3050);
    EXPECT_GT(towns[i].point.y, 3000);
    EXPECT_NEAR(towns[i].importance, std::round(wish.largest / (i + 1)), 1e-6);
  }
}

}  // namespace
}  // namespace streetgen
