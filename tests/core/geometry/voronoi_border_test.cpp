#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <random>

#include "geometry/box.hpp"
#include "geometry/polyline.hpp"
#include "geometry/voronoi_border.hpp"

namespace streetgen {
namespace voronoi_border_test {

double nearest(const std::vector<Site>& sites, const Point& p, bool first) {
  double best = std::numeric_limits<double>::infinity();
  for (const Site& site : sites)
    if (site.first == first) best = std::min(best, distance(site.point, p));
  return best;
}

Box box_of(const std::vector<Site>& sites, double margin) {
  Box box;
  for (const Site& site : sites) box.add(site.point);
  return box.grown(margin);
}

// Each edge lies where both owners are equally near, and the ends of all form lines that go on up
// to the outside of the box.
void expect_border(const std::vector<Site>& sites, const Box& within) {
  std::map<std::pair<double, double>, int> ends;
  for (const auto& [from, to] : VoronoiBorder(sites, within).border()) {
    for (const double t : {0.0, 0.3, 1.0}) {
      const Point p = from + (to - from) * t;
      EXPECT_NEAR(nearest(sites, p, true), nearest(sites, p, false), 1e-5);
    }
    ++ends[{from.x, from.y}];
    ++ends[{to.x, to.y}];
  }
  for (const auto& [end, count] : ends)
    if (within.holds({end.first, end.second, 0}, 0.5)) {
      EXPECT_EQ(count % 2, 0) << end.first << " " << end.second;
    }
}

std::vector<Site> random_sites(std::mt19937& random, int count, double share) {
  std::uniform_real_distribution<double> place(0, 50), coin(0, 1);
  std::vector<Site> sites{{{650000, 6860000, 0}, true}, {{650050, 6860050, 0}, false}};
  for (int i = 0; i < count; ++i)
    sites.push_back({{650000 + place(random), 6860000 + place(random), 0}, coin(random) < share});
  return sites;
}

TEST(Nearest, PlacesAreOfTheOwnerOfTheNearestSite) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0, 50);
  for (const int count : {40, 1100})
    for (int round = 0; round < (count > 1000 ? 1 : 50); ++round) {
      const std::vector<Site> sites = random_sites(random, count, 0.4);
      const VoronoiBorder nearer(sites, box_of(sites, 0));
      for (int i = 0; i < 200; ++i) {
        const Point p{650000 + place(random), 6860000 + place(random), 0};
        const double ahead = nearest(sites, p, false) - nearest(sites, p, true);
        if (std::abs(ahead) > 1e-4) {
          EXPECT_EQ(nearer.first_owns(p), ahead > 0);
        }
      }
    }
}

// Wherever the owner changes on the way from a place to another, the way meets the border.
TEST(Nearest, TheBorderPartsTheOwners) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(5, 45);
  for (const int count : {2, 5, 40, 1100})
    for (int round = 0; round < (count > 1000 ? 1 : 40); ++round) {
      const std::vector<Site> sites = random_sites(random, count, round % 2 == 0 ? 0.4 : 0.05);
      const Box within{650005, 6860005, 650045, 6860045};
      expect_border(sites, within);
      const VoronoiBorder nearer(sites, within);
      const auto border = nearer.border();
      for (int i = 0; i < 40; ++i) {
        const Point p{650000 + place(random), 6860000 + place(random), 0};
        const Point q{650000 + place(random), 6860000 + place(random), 0};
        const auto met = std::count_if(border.begin(), border.end(), [&](const auto& edge) {
          return crossing(p, q, edge.first, edge.second).has_value();
        });
        EXPECT_EQ(met % 2 == 1, nearer.first_owns(p) != nearer.first_owns(q));
      }
    }
}

// Where many cells meet in one place.
TEST(Nearest, TheBorderOfARegularGridHasNoGaps) {
  std::vector<Site> sites;
  for (int x = 0; x < 6; ++x)
    for (int y = 0; y < 6; ++y)
      sites.push_back({{1.0 * x, 1.0 * y, 0}, x > 0 && y > 0 && x < 5 && y < 5});
  expect_border(sites, box_of(sites, 0));
  double length = 0;
  for (const auto& [from, to] : VoronoiBorder(sites, box_of(sites, 0)).border())
    length += distance(from, to);
  EXPECT_NEAR(length, 16, 1e-6);
  for (int x = 0; x < 6; ++x)
    for (int y = 0; y < 6; ++y) sites[6 * x + y].first = (x + y) % 2 == 0;
  length = 0;
  for (const auto& [from, to] : VoronoiBorder(sites, box_of(sites, 0)).border())
    length += distance(from, to);
  EXPECT_NEAR(length, 2 * 5 * 7, 1e-6);  // each line up to a metre outside
}

TEST(Nearest, ACellAmongTheOthersHasABorder) {
  std::vector<Site> sites;
  for (int x = 0; x < 5; ++x)
    for (int y = 0; y < 5; ++y) sites.push_back({{1.0 * x, 1.0 * y, 0}, x != 2 || y != 2});
  expect_border(sites, box_of(sites, 0));
  EXPECT_EQ(VoronoiBorder(sites, box_of(sites, 0)).border().size(), 4u);
}

TEST(Nearest, OfSitesInOnePlaceTheEarlierCounts) {
  const Point here{10, 10, 0}, there{20, 10, 0};
  const Box within{0, 0, 30, 20};
  EXPECT_TRUE(
      VoronoiBorder({{here, true}, {here, false}, {there, false}}, within).first_owns(here));
  EXPECT_FALSE(
      VoronoiBorder({{here, false}, {here, true}, {there, false}}, within).first_owns(here));
}

}  // namespace voronoi_border_test
}  // namespace streetgen
