#include "network/leaving_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace streetgen {
namespace leaving_order_test {

// The direction of a way that bends 3 m, 6 m and 12 m from its node.
struct Way {
  double leaves, bends[3];
  int rank;
};

double heading(const Way& way, double at) {
  double direction = way.leaves;
  for (int i = 0; i < 3; ++i)
    if (at > 3 * (1 << i)) direction += way.bends[i];
  return std::remainder(direction, 2 * M_PI);
}

// The ranks of the ways counter-clockwise from the first one.
std::vector<int> order_of(const std::vector<Way>& ways) {
  std::vector<int> ranks;
  for (const std::size_t i : leaving_order(
           ways.size(), [&](std::size_t i, double at) { return heading(ways[i], at); },
           [&](std::size_t i, std::size_t j) { return ways[i].rank < ways[j].rank; }))
    ranks.push_back(ways[i].rank);
  std::rotate(ranks.begin(), std::find(ranks.begin(), ranks.end(), 0), ranks.end());
  return ranks;
}

Way mirrored(Way way) {
  way.leaves = -way.leaves;
  for (double& bend : way.bends) bend = -bend;
  return way;
}

// The same the other way about.
std::vector<int> backwards(std::vector<int> ranks) {
  std::reverse(ranks.begin() + 1, ranks.end());
  return ranks;
}

TEST(LeavingOrder, IsThatOfTheDirections) {
  EXPECT_EQ(order_of({{0, {}, 0}, {2, {}, 2}, {1, {}, 1}, {-1, {}, 3}}),
            (std::vector<int>{0, 1, 2, 3}));
}

TEST(LeavingOrder, IsThatOfThePlaceWhereWaysPart) {
  EXPECT_EQ(order_of({{0, {}, 0}, {1, {0, 0.2}, 3}, {1, {-0.1, 0.5}, 1}, {1, {0, 0.1}, 2}}),
            (std::vector<int>{0, 1, 2, 3}));
}

TEST(LeavingOrder, PutsTheFirstOfWaysThatNeverPartBesideTheNearerNeighbour) {
  EXPECT_EQ(order_of({{0, {}, 0}, {1, {}, 1}, {1, {}, 2}, {3, {}, 3}}),
            (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(order_of({{0, {}, 0}, {3, {}, 1}, {3, {}, 2}, {4, {}, 3}}),
            (std::vector<int>{0, 2, 1, 3}));
}

// Ways a third of the noise apart leave together, whatever their order and number, and wherever the
// seam of the circle lies.
TEST(LeavingOrder, DoesNotDependOnOrderTurnOrSide) {
  std::mt19937 random(7);
  const double directions[] = {0, 1.9, 4.0};
  const auto pick = [&](int below) { return static_cast<int>(random() % below); };
  for (int round = 0; round < 3000; ++round) {
    std::vector<Way> ways;
    const int count = 2 + pick(7);
    for (int rank = 0; rank < count; ++rank) {
      Way way{directions[pick(3)] + pick(4) * 3e-7, {}, rank};
      for (double& bend : way.bends) bend = (pick(3) - 1) * 0.25 + pick(4) * 3e-7;
      ways.push_back(way);
    }
    const std::vector<int> order = order_of(ways);
    std::vector<Way> mirror;
    for (const Way& way : ways) mirror.push_back(mirrored(way));
    EXPECT_EQ(order_of(mirror), backwards(order)) << round;
    std::shuffle(ways.begin(), ways.end(), random);
    const double turn = M_PI * pick(8) / 4 + pick(3) * 1e-7;
    for (Way& way : ways) way.leaves += turn;
    EXPECT_EQ(order_of(ways), order) << round;
  }
}

}  // namespace leaving_order_test
}  // namespace streetgen
