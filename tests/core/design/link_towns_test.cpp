#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "geometry/polyline.hpp"
#include "made_terrain.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"
#include "streetgen/road_network.hpp"
#include "support/disjoint_sets.hpp"

namespace streetgen {
namespace link_towns_test {

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

std::vector<Town> random_towns(std::mt19937& random, std::size_t count) {
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<Town> towns;
  for (std::size_t i = 0; i < count; ++i) {
    const TownKind kind = i < count / 6   ? TownKind::city
                          : i < count / 2 ? TownKind::town
                                          : TownKind::village;
    towns.push_back({kind, 500000.0 / (1 + i), {2e5 * share(random), 1e5 * share(random), 0}});
  }
  return towns;
}

// The rule word by word: the worst link goes, all benefits are known anew.
class WorstFirst {
 public:
  explicit WorstFirst(const std::vector<Town>& towns)
      : towns_(towns), linked_(towns.size(), std::vector<bool>(towns.size(), false)) {}

  std::vector<std::pair<std::size_t, std::size_t>> links() {
    for (int kind = 0; kind < 3; ++kind) add(kind);
    std::vector<std::pair<std::size_t, std::size_t>> links;
    for (std::size_t a = 0; a < towns_.size(); ++a)
      for (std::size_t b = a + 1; b < towns_.size(); ++b)
        if (linked_[a][b]) links.emplace_back(a, b);
    return links;
  }

 private:
  double length(std::size_t a, std::size_t b) const {
    return distance(towns_[a].point, towns_[b].point) / 1000;
  }
  void link(std::size_t a, std::size_t b, bool there) { linked_[a][b] = linked_[b][a] = there; }

  double way_beside(std::size_t a, std::size_t b) const {
    const double infinite = std::numeric_limits<double>::infinity();
    std::vector<double> reached(towns_.size(), infinite);
    reached[a] = 0;
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t i = 0; i < towns_.size(); ++i)
        for (std::size_t k = 0; k < towns_.size(); ++k) {
          if (!linked_[i][k] || (i == a && k == b) || (i == b && k == a)) continue;
          if (!(reached[i] + length(i, k) < reached[k] * (1 - 1e-14))) continue;
          reached[k] = reached[i] + length(i, k);
          changed = true;
        }
    }
    return reached[b];
  }

  void add(int kind) {
    std::vector<std::pair<std::size_t, std::size_t>> open;
    for (std::size_t a = 0; a < towns_.size(); ++a)
      for (std::size_t b = a + 1; b < towns_.size(); ++b)
        if (std::max(static_cast<int>(towns_[a].kind), static_cast<int>(towns_[b].kind)) == kind) {
          open.emplace_back(a, b);
          link(a, b, true);
        }
    for (;;) {
      double worst = 0;
      std::size_t at = open.size();
      for (std::size_t i = 0; i < open.size(); ++i) {
        const auto [a, b] = open[i];
        const double straight = length(a, b);
        const double used = towns_[a].importance * towns_[b].importance / 1e6 / straight / straight;
        const double worth = 27.5 * used * (way_beside(a, b) - straight) - straight;
        if (worth < worst) worst = worth, at = i;
      }
      if (at == open.size()) return;
      link(open[at].first, open[at].second, false);
      open.erase(open.begin() + at);
    }
  }

  const std::vector<Town>& towns_;
  std::vector<std::vector<bool>> linked_;
};

TEST(LinkTowns, TheWorstGoesFirst) {
  std::mt19937 random(5);
  for (std::size_t count : {2, 3, 7, 14, 18, 22}) {
    const std::vector<Town> towns = random_towns(random, count);
    std::vector<std::pair<std::size_t, std::size_t>> links;
    for (const TownLink& link : link_towns(towns, {})) links.emplace_back(link.a, link.b);
    std::sort(links.begin(), links.end());
    EXPECT_EQ(links, WorstFirst(towns).links()) << count;
  }
}

thread_local std::size_t asked = 0, stops_at = 0;
bool count_and_stop() noexcept { return ++asked == stops_at; }

// How often a computation asks whether it should stop.
std::size_t times_asked(std::size_t towns, LinkBenefit benefit) {
  std::mt19937 random(3);
  NetworkWish wish;
  wish.benefit = benefit;
  asked = stops_at = 0;
  set_cancel_check(count_and_stop);
  link_towns(random_towns(random, towns), wish);
  set_cancel_check(nullptr);
  return asked;
}

TEST(LinkTowns, EachSearchAsksWhetherItShouldStopAndIsDoneAFewTimesALink) {
  const auto pairs = [](std::size_t n) { return n * (n - 1) / 2; };
  for (std::size_t n : {30, 60, 120, 240}) {
    const std::size_t times = times_asked(n, LinkBenefit::of_ends);
    EXPECT_GE(times, 2 * pairs(n)) << n;
    EXPECT_LE(times, 8 * pairs(n)) << n;
  }
  EXPECT_GE(times_asked(20, LinkBenefit::of_network), 20 * pairs(20) / 2);
}

TEST(LinkTowns, ItStopsWhenAsked) {
  std::mt19937 random(3);
  const std::vector<Town> towns = random_towns(random, 60);
  const std::size_t times = times_asked(60, LinkBenefit::of_ends);
  for (std::size_t k = 1; k < times; k += times / 20) {
    asked = 0, stops_at = k;
    set_cancel_check(count_and_stop);
    try {
      link_towns(towns, {});
      ADD_FAILURE() << "goes on after " << k;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::cancelled);
    }
    set_cancel_check(nullptr);
    EXPECT_EQ(asked, k);
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

}  // namespace link_towns_test
}  // namespace streetgen
