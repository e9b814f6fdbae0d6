#include "virtual_city/growth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "cities.hpp"
#include "geometry/polyline.hpp"

namespace streetgen {
namespace growth_test {

double longest(const CityExtent& extent, const CityOptions& options, int level) {
  return std::max(extent.width, extent.height) * std::pow(options.length_ratio, level);
}

// Starts of the outgoing roads of each road, along it.
std::vector<std::vector<double>> starts(const std::vector<CityStreet>& streets) {
  std::vector<std::vector<double>> found(streets.size());
  for (const CityStreet& street : streets)
    if (street.main >= 0)
      found[street.main].push_back(
          nearest_abscissa(street.line.front(), streets[street.main].line));
  return found;
}

TEST(CityGrowth, FirstRoadCrossesTheWholeMap) {
  for (int seed = 1; seed <= 5; ++seed) {
    const CityStreet wide = grown_streets(town, seed, {})[0];
    EXPECT_EQ(wide.line.front().x, 0);
    EXPECT_EQ(wide.line.back().x, town.width);
    const CityStreet high = grown_streets({0, 0, 5000, 8000}, seed, {})[0];
    EXPECT_EQ(high.line.front().y, 0);
    EXPECT_EQ(high.line.back().y, 8000);
  }
}

TEST(CityGrowth, IsStraightUnlessAskedToBend) {
  CityOptions bent;
  bent.bend = 10;
  for (const CityStreet& street : grown_streets(town, 1, {})) EXPECT_EQ(street.line.size(), 2u);
  const std::vector<CityStreet> streets = grown_streets(town, 1, bent);
  EXPECT_TRUE(std::any_of(streets.begin(), streets.end(),
                          [](const CityStreet& s) { return s.line.size() > 10; }));
  for (const CityStreet& street : streets)
    for (std::size_t i = 2; i < street.line.size(); ++i)
      EXPECT_LT(angle(street.line[i] - street.line[i - 1], street.line[1] - street.line[0]), 75);
}

TEST(CityGrowth, LengthAndWidthShrinkWithTheLevel) {
  for (const CityOptions& options : kinds()) {
    for (const CityStreet& street : grown_streets(town, 2, options)) {
      EXPECT_LE(street.length(), street.main < 0
                                     ? 1.5 * town.width
                                     : longest(town, options, street.level) + options.node_gap);
      EXPECT_EQ(street.width, street.level == 0 ? 18 : street.level == 1 ? 12 : 6);
    }
  }
}

TEST(CityGrowth, StartsAreTheGapApart) {
  for (const CityOptions& options : kinds()) {
    const std::vector<CityStreet> streets = grown_streets(town, 3, options);
    const std::vector<std::vector<double>> all = starts(streets);
    for (std::size_t i = 0; i < streets.size(); ++i)
      for (std::size_t k = 0; k < all[i].size(); ++k) {
        EXPECT_GE(all[i][k], options.start_gap - 0.01);
        EXPECT_LE(all[i][k], streets[i].length() - options.start_gap + 0.01);
        if (k > 0) {
          EXPECT_GE(all[i][k] - all[i][k - 1], options.start_gap - 0.01);
        }
      }
  }
}

TEST(CityGrowth, EndsMayBeNearerThanTheGap) {
  const std::vector<CityStreet> streets = grown_streets(paper, 1, {});
  bool nearer = false;
  for (const CityStreet& street : streets)
    for (std::size_t k = 1; k < street.nodes.size(); ++k)
      nearer = nearer || street.nodes[k].abscissa - street.nodes[k - 1].abscissa < 39;
  EXPECT_TRUE(nearer);
}

TEST(CityGrowth, NumberOfOutgoingRoadsIsLimitedByTheLengthOfTheMainRoad) {
  for (const CityOptions& options : kinds()) {
    const std::vector<CityStreet> streets = grown_streets(town, 4, options);
    const std::vector<std::vector<double>> all = starts(streets);
    for (std::size_t i = 0; i < streets.size(); ++i) {
      const double spacing =
          std::max(options.spacing_least,
                   options.spacing_ratio * longest(town, options, streets[i].level + 1));
      EXPECT_LE(all[i].size() * spacing, streets[i].length() + 1e-6);
    }
  }
}

TEST(CityGrowth, StopsWhereALengthHasNoPlaceForOutgoingRoads) {
  const std::vector<CityStreet> streets = grown_streets(town, 5, {});
  const std::vector<std::vector<double>> all = starts(streets);
  int without = 0;
  for (std::size_t i = 0; i < streets.size(); ++i) {
    if (streets[i].length() >= CityOptions{}.spacing_least) continue;
    EXPECT_TRUE(all[i].empty());
    ++without;
  }
  EXPECT_GT(without, 20);
  CityOptions none;
  none.spacing_least = 1e5;
  EXPECT_EQ(grown_streets(town, 5, none).size(), 1u);
}

TEST(CityGrowth, SmallerRoadsAreShorterAndPackedMoreDensely) {
  std::map<int, std::vector<double>> lengths, gaps;
  for (int seed = 1; seed <= 5; ++seed) {
    const std::vector<CityStreet> streets = grown_streets(paper, seed, {});
    const std::vector<std::vector<double>> all = starts(streets);
    for (std::size_t i = 0; i < streets.size(); ++i) {
      lengths[streets[i].level].push_back(streets[i].length());
      for (std::size_t k = 1; k < all[i].size(); ++k)
        gaps[streets[i].level + 1].push_back(all[i][k] - all[i][k - 1]);
    }
  }
  const auto mean = [](const std::vector<double>& of) {
    return std::accumulate(of.begin(), of.end(), 0.0) / of.size();
  };
  for (int level = 1; level <= 5; ++level)
    EXPECT_LT(mean(lengths[level]), mean(lengths[level - 1])) << level;
  for (int level = 2; level <= 4; ++level)
    EXPECT_LT(mean(gaps[level]), mean(gaps[level - 1])) << level;
}

TEST(CityGrowth, NoRoadStartsWhereOneAlreadyLies) {
  for (const CityOptions& options : kinds()) {
    const std::vector<CityStreet> streets = grown_streets(town, 6, options);
    for (std::size_t i = 1; i < streets.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (static_cast<int>(k) != streets[i].main) {
          EXPECT_GE(distance_to_line(streets[i].line.front(), streets[k].line),
                    (streets[i].width + streets[k].width) / 2 + options.clearance - 0.01);
        }
  }
}

TEST(CityGrowth, RoadsStartOnlyWhereTheDensityReachesTheThreshold) {
  CityOptions narrow;
  narrow.threshold = {0.8, 0.8};
  for (const CityStreet& street : grown_streets(town, 7, narrow))
    EXPECT_GE(street.main < 0 ? 1 : city_density(street.line.front(), town, narrow), 0.8);
  // Drawn anew for every start: between its two ends some start and some do not.
  const std::vector<CityStreet> streets = grown_streets(paper, 7, {});
  double least = 1;
  for (const CityStreet& street : streets)
    if (street.main >= 0)
      least = std::min(least, city_density(street.line.front(), {0, 0, 20000, 10000}, {}));
  EXPECT_GE(least, 0.5);
  EXPECT_LT(least, 0.6);
  CityOptions high, low;
  high.threshold = {0.75, 0.75};
  low.threshold = {0.5, 0.5};
  EXPECT_LT(grown_streets(paper, 7, high).size(), streets.size());
  EXPECT_GT(grown_streets(paper, 7, low).size(), streets.size());
}

TEST(CityGrowth, FourOfFiveRoadsLeaveAtARightAngle) {
  const auto right = [](double share) {
    CityOptions options;
    options.right_angles = share;
    int right = 0, all = 0;
    for (int seed = 1; seed <= 5; ++seed) {
      const std::vector<CityStreet> streets = grown_streets(paper, seed, options);
      for (const CityStreet& street : streets) {
        // One that ends in a node was turned to it, a long one by less than 3 degrees.
        if (street.main < 0 || street.length() < 300) continue;
        const Line& main = streets[street.main].line;
        const double turn = angle(street.line[1] - street.line[0], main[1] - main[0]);
        right += std::abs(turn - 90) < 3;
        ++all;
        EXPECT_GT(turn, options.angle_least - 3);
        EXPECT_LT(turn, 180 - options.angle_least + 3);
      }
    }
    return static_cast<double>(right) / all;
  };
  EXPECT_EQ(right(1), 1);
  // Of the others some are as near to it: 3 degrees of 45.
  EXPECT_NEAR(right(0.8), 0.8 + 0.2 * 3 / 45, 0.05);
  EXPECT_NEAR(right(0), 3.0 / 45, 0.05);
}

TEST(CityGrowth, EndsAtTheBorderAtARoadOrAsABlindAlley) {
  for (const CityOptions& options : kinds()) {
    const std::vector<CityStreet> streets = grown_streets(town, 8, options);
    std::set<CityEnd> seen;
    for (const CityStreet& street : streets) {
      const Point tip = street.line.back();
      seen.insert(street.end);
      const bool on_border =
          tip.x == 0 || tip.y == 0 || tip.x == town.width || tip.y == town.height;
      EXPECT_EQ(street.end == CityEnd::border, on_border);
      if (street.end == CityEnd::road) {
        EXPECT_LT(distance_to_line(tip, streets[street.ends_on].line), 0.003);
      }
    }
    EXPECT_EQ(seen.size(), 3u);
  }
}

TEST(CityGrowth, FewRoadsLeaveTheCity) {
  for (const double transit : {2, 5})
    for (int seed = 1; seed <= 5; ++seed) {
      CityOptions options;
      options.transit = transit;
      const std::vector<CityStreet> streets = grown_streets(paper, seed, options);
      // The first road leaves twice.
      EXPECT_LE(1 + std::count_if(streets.begin(), streets.end(),
                                  [](const CityStreet& s) { return s.end == CityEnd::border; }),
                transit);
    }
}

}  // namespace growth_test
}  // namespace streetgen
