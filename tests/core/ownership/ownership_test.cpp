#include "ownership/ownership.hpp"

#include <gtest/gtest.h>

#include <list>
#include <random>

#include "geometry/geos.hpp"
#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "ownership/hole.hpp"
#include "rounds.hpp"
#include "streetgen/surface.hpp"

namespace streetgen {
namespace ownership_test {

// Streets with their surfaces, as ownership takes them.
struct Town {
  std::list<Line> axes;
  std::list<MultiPolygon> surfaces;
  std::vector<Claim> claims;

  void add(const Line& axis, double width) {
    axes.push_back(axis);
    surfaces.push_back(section_surface(axis, width, 0, length(axis)));
    Claim claim;
    claim.surface = &surfaces.back();
    claim.skeleton.push_back({&axes.back(), 0, length(axis)});
    claim.width = width;
    claim.axis_id = static_cast<std::int64_t>(claims.size()) + 1;
    claim.edges = {static_cast<int>(claims.size())};
    claims.push_back(claim);
  }
  std::vector<MultiPolygon> grounds() const { return {surfaces.begin(), surfaces.end()}; }
};

double united_area(Geos& geos, const Town& town) {
  return area(geos.polygons(geos.unite(town.grounds()).get()));
}

double summed_area(const Town& town) {
  double sum = 0;
  for (const MultiPolygon& surface : town.surfaces) sum += area(surface);
  return sum;
}

TEST(Ownership, EveryPointKeepsOneOwner) {
  Geos geos;
  for (int seed = 1; seed <= rounds(100); ++seed) {
    std::mt19937_64 random(seed);
    const auto place = [&] { return Point{random() % 800 / 10.0, random() % 800 / 10.0, 0}; };
    Town town;
    for (int i = 0; i < 8; ++i) {
      const Point a = place(), b = place();
      if (distance(a, b) > 1) town.add({a, b}, 4 + random() % 100 / 10.0);
    }
    const double ground = united_area(geos, town);
    settle_ownership(geos, town.claims, disputes(town.claims));
    EXPECT_NEAR(united_area(geos, town), ground, 0.01) << "seed " << seed;
    EXPECT_NEAR(summed_area(town), ground, 0.01) << "seed " << seed;
  }
}

// Of three axes on one line but for noise each is as near as the next, and the last nearer than the
// first; a fourth, before them in rank, lies beside them.
TEST(Ownership, AxesThatNoiseTellsApartLeaveNoGroundToNobody) {
  Geos geos;
  Town town;
  for (const double off : {-0.5, 0.0, 8e-6, 16e-6}) town.add({{0, off, 0}, {20.5, off, 0}}, 4);
  const double ground = united_area(geos, town);
  settle_ownership(geos, town.claims, disputes(town.claims));
  EXPECT_NEAR(united_area(geos, town), ground, 1e-3);
  EXPECT_NEAR(summed_area(town), ground, 1e-3);
}

// Streets of two levels, some of which also tile with one of the other.
TEST(Ownership, WhereLevelsMeetAPlaceIsOwnedOnceByWhatTiles) {
  Geos geos;
  for (int seed = 1; seed <= rounds(100); ++seed) {
    std::mt19937_64 random(seed);
    const auto place = [&] { return Point{random() % 400 / 10.0, random() % 400 / 10.0, 0}; };
    Town town;
    while (town.claims.size() < 7) {
      const Point a = place(), b = place();
      if (distance(a, b) < 1) continue;
      town.add({a, b}, 4 + random() % 100 / 10.0);
      Claim& claim = town.claims.back();
      claim.level = static_cast<int>(random() % 2);
      claim.importance = static_cast<int>(random() % 3);
      claim.edges.push_back(static_cast<int>(random() % 7));
    }
    const std::vector<MultiPolygon> before = town.grounds();
    settle_ownership(geos, town.claims, disputes(town.claims));
    for (int k = 0; k < 400; ++k) {
      const Point at = place() + Point{0.0317, 0.0271, 0};
      for (std::size_t i = 0; i < before.size(); ++i) {
        if (!PreparedSurface(before[i]).holds(at)) continue;
        int others = 0;
        for (std::size_t j = 0; j < before.size(); ++j)
          others += j != i && tile(town.claims[i], town.claims[j]) &&
                    PreparedSurface(*town.claims[j].surface).holds(at);
        // Others may both own it where they do not tile with each other.
        if (PreparedSurface(*town.claims[i].surface).holds(at))
          EXPECT_EQ(others, 0) << "seed " << seed;
        else
          EXPECT_GT(others, 0) << "seed " << seed;
      }
    }
  }
}

// Four streets about a gap of 0.5 m by 0.375 m, places of the grid of arrangements, each
// overlapping the next.
TEST(Holes, GoToTheNeighbourWithTheLongestBorder) {
  Geos geos;
  Town town;
  town.add({{-10, -2, 0}, {10, -2, 0}}, 4);
  town.add({{-10, 2.375, 0}, {10, 2.375, 0}}, 4);
  town.add({{-2, -10, 0}, {-2, 10, 0}}, 4);
  town.add({{2.5, -10, 0}, {2.5, 10, 0}}, 4);
  const double ground = united_area(geos, town);
  const auto pairs = disputes(town.claims);
  EXPECT_TRUE(holes_between(town.claims, pairs, 0.1).empty());
  const std::vector<Hole> holes = holes_between(town.claims, pairs, 0.5);
  ASSERT_EQ(holes.size(), 1u);
  EXPECT_NEAR(std::abs(signed_area(holes.front().ring)), 0.1875, 1e-9);
  settle_ownership(geos, town.claims, pairs);
  const double first = area(town.surfaces.front());
  give_holes(geos, town.claims, holes);
  EXPECT_NEAR(united_area(geos, town), ground + 0.1875, 1e-6);
  EXPECT_NEAR(summed_area(town), ground + 0.1875, 1e-6);
  EXPECT_NEAR(area(town.surfaces.front()), first + 0.1875, 1e-6);
}

// Two surfaces that touch in two points and nowhere else.
// At one of the places exactly, or with five nanometres between them.
TEST(Holes, LieBetweenSurfacesThatTouchInPoints) {
  for (const double gap : {0.0, 5e-9}) {
    MultiPolygon left{{{{0, 0, 0}, {10, 4, 0}, {9.7, 4.5, 0}, {10, 5, 0}, {0, 9, 0}, {0, 0, 0}}}};
    MultiPolygon right{
        {{{20, 0, 0}, {20, 9, 0}, {10, 5, 0}, {10.3, 4.5, 0}, {10 + gap, 4, 0}, {20, 0, 0}}}};
    std::vector<Claim> claims(2);
    claims[0].surface = &left;
    claims[1].surface = &right;
    claims[1].order_key = 1;
    for (Claim& claim : claims) claim.edges = {1, 2};
    const std::vector<Hole> holes = holes_between(claims, {}, 0.5);
    ASSERT_EQ(holes.size(), 1u) << gap;
    EXPECT_NEAR(std::abs(signed_area(holes.front().ring)), 0.3, gap == 0 ? 1e-9 : 1e-7);
  }
}

// About 0.6 m by 0.5 m the left street disputes with the upper one and the right with the lower;
// only by the one beyond do edges lead from the upper to the right.
TEST(Holes, LieBetweenDisputesThatEdgesJoin) {
  Geos geos;
  const auto rectangle = [](double x, double y, double to_x, double to_y) {
    return MultiPolygon{{{{x, y, 0}, {to_x, y, 0}, {to_x, to_y, 0}, {x, to_y, 0}, {x, y, 0}}}};
  };
  std::vector<MultiPolygon> surfaces{
      rectangle(-5, -5, 5, 0),    // lower
      rectangle(-5, 0, 0, 5),     // left
      rectangle(-2, 0.5, 2, 3),   // upper
      rectangle(2, 0.5, 5, 3),    // beyond
      rectangle(0.6, -1, 4, 0.5)  // right
  };
  const std::vector<std::vector<int>> edges{{1}, {1}, {2}, {2, 3}, {3}};
  std::vector<Claim> claims(surfaces.size());
  for (std::size_t i = 0; i < claims.size(); ++i) {
    claims[i].surface = &surfaces[i];
    claims[i].edges = edges[i];
    claims[i].order_key = static_cast<std::int64_t>(i);
  }
  const std::vector<std::pair<int, int>> pairs = disputes(claims);
  ASSERT_EQ(pairs, (std::vector<std::pair<int, int>>{{0, 4}, {1, 2}}));
  const std::vector<Hole> holes = holes_between(claims, pairs, 0.5);
  ASSERT_EQ(holes.size(), 1u);
  EXPECT_NEAR(std::abs(signed_area(holes.front().ring)), 0.3, 1e-7);
}

// Two of its corners are nearer to each other than settling may move them.
TEST(Holes, AreFilledToTheirNarrowestCorner) {
  Geos geos;
  const Ring needle{{5, 5, 0}, {15, 5, 0}, {15, 5 + 4e-7, 0}, {5, 5, 0}};
  MultiPolygon frame{
      {{{0, 0, 0}, {20, 0, 0}, {20, 20, 0}, {0, 20, 0}, {0, 0, 0}}, reversed(needle)}};
  Claim claim;
  claim.surface = &frame;
  std::vector<Claim> claims{claim};
  give_holes(geos, claims, {{needle, {0}}});
  ASSERT_EQ(frame.size(), 1u);
  EXPECT_EQ(frame[0].size(), 1u);
}

// Its far side has a corner nearer to one of the surface's than settling may move that.
TEST(Holes, AreFilledUpToTheirFarSide) {
  Geos geos;
  const Point bend{4, -4e-7, 0};
  MultiPolygon below{{{{0, -5, 0}, {10, -5, 0}, {10, 0, 0}, bend, {0, 0, 0}, {0, -5, 0}}}};
  Claim claim;
  claim.surface = &below;
  std::vector<Claim> claims{claim};
  give_holes(geos, claims, {{{{0, 0, 0}, bend, {10, 0, 0}, {4, 0, 0}, {0, 0, 0}}, {0}}});
  EXPECT_NEAR(area(below), 50, 1e-9);
}

// The union that finds a hole may move its corners by the noise of coordinates.
TEST(Holes, LeaveNoHairlineAroundWhatWasFilled) {
  Geos geos;
  MultiPolygon frame{{{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}, {0, 0, 0}},
                      {{5, 5, 0}, {5, 5.5, 0}, {5.5, 5.5, 0}, {5.5, 5, 0}, {5, 5, 0}}}};
  Claim claim;
  claim.surface = &frame;
  std::vector<Claim> claims{claim};
  const Ring moved{{5, 5, 0},
                   {5.5 - 2e-7, 5 + 3e-7, 0},
                   {5.5 - 3e-7, 5.5 - 2e-7, 0},
                   {5 + 2e-7, 5.5 - 3e-7, 0},
                   {5, 5, 0}};
  give_holes(geos, claims, {{moved, {0}}});
  ASSERT_EQ(frame.size(), 1u);
  EXPECT_EQ(frame[0].size(), 1u);
  EXPECT_NEAR(area(frame), 100, 1e-9);
}

}  // namespace ownership_test
}  // namespace streetgen
