#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "../../src/core/nearest.hpp"
#include "../../src/core/overlap.hpp"
#include "../../src/core/polyline.hpp"

namespace streetgen {
namespace {

double nearest(const std::vector<Site>& sites, const Point& p, bool first) {
  double best = std::numeric_limits<double>::infinity();
  for (const Site& site : sites)
    if (site.first == first) best = std::min(best, distance(site.point, p));
  return best;
}

bool holds(const MultiPolygon& ground, const Point& p) {
  for (const Polygon& polygon : ground)
    if (inside(p, polygon)) return true;
  return false;
}

TEST(Nearest, PlacesAreOfTheOwnerOfTheNearestSite) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0, 50), coin(0, 1);
  for (int round = 0; round < 50; ++round) {
    std::vector<Site> sites{{{650000, 6860000, 0}, true}, {{650050, 6860050, 0}, false}};
    for (int i = 0; i < 40; ++i)
      sites.push_back({{650000 + place(random), 6860000 + place(random), 0}, coin(random) < 0.4});
    const MultiPolygon ground = nearest_to_first(sites, 20);
    for (int i = 0; i < 200; ++i) {
      const Point p{650000 + place(random), 6860000 + place(random), 0};
      const double ahead = nearest(sites, p, false) - nearest(sites, p, true);
      if (std::abs(ahead) > 1e-4) {
        EXPECT_EQ(holds(ground, p), ahead > 0);
      }
    }
  }
}

TEST(Nearest, ARegularGridOfSitesHasNoGaps) {
  std::vector<Site> sites;
  for (int x = 0; x < 6; ++x)
    for (int y = 0; y < 6; ++y)
      sites.push_back({{1.0 * x, 1.0 * y, 0}, x > 0 && y > 0 && x < 5 && y < 5});
  const MultiPolygon ground = nearest_to_first(sites, 5);
  ASSERT_EQ(ground.size(), 1u);
  EXPECT_EQ(ground[0].size(), 1u);
  EXPECT_NEAR(area(ground), 16, 1e-6);
}

TEST(Nearest, AnOwnerInsideTheOtherMakesAHole) {
  std::vector<Site> sites;
  for (int x = 0; x < 5; ++x)
    for (int y = 0; y < 5; ++y) sites.push_back({{1.0 * x, 1.0 * y, 0}, x != 2 || y != 2});
  const MultiPolygon ground = nearest_to_first(sites, 5);
  ASSERT_EQ(ground.size(), 1u);
  ASSERT_EQ(ground[0].size(), 2u);
  EXPECT_NEAR(signed_area(ground[0][1]), -1, 1e-6);
}

TEST(Nearest, OfSitesInOnePlaceTheEarlierCounts) {
  const Point here{10, 10, 0}, there{20, 10, 0};
  EXPECT_TRUE(holds(nearest_to_first({{here, true}, {here, false}, {there, false}}, 10), here));
  EXPECT_FALSE(holds(nearest_to_first({{here, false}, {here, true}, {there, false}}, 10), here));
}

}  // namespace
}  // namespace streetgen
