#include "streetgen/first_within.hpp"

namespace streetgen {
namespace {

TEST(FirstWithin, ThoseThatStandAreApartAndTheOthersNear) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> at(-2, 2);
  std::vector<Point> places;
  for (int i = 0; i < 3000; ++i) places.push_back({at(random), at(random), i % 2 * 5.0});
  const std::vector<int> first = first_within(places, std::vector<long>(places.size()), 0.1);
  const auto apart = [&](int a, int b) {
    return std::hypot(places[a].x - places[b].x, places[a].y - places[b].y,
                      places[a].z - places[b].z);
  };
  std::vector<int> standing;
  for (int i = 0; i < 3000; ++i) {
    EXPECT_EQ(first[first[i]], first[i]);
    EXPECT_LE(first[i], i);
    if (first[i] != i) EXPECT_LT(apart(i, first[i]), 0.1);
    if (first[i] == i) standing.push_back(i);
  }
  for (const int a : standing)
    for (const int b : standing)
      if (a != b) EXPECT_GE(apart(a, b), 0.1);
}

TEST(FirstWithin, APlaceOfAGroupKeepsToIt) {
  const std::vector<Point> places{{0, 0}, {0.01, 0}, {0.02, 0}, {0.03, 0}};
  EXPECT_EQ(first_within(places, {1, 2, 2, 0}, 0.05), (std::vector<int>{0, 1, 1, 1}));
}

TEST(FirstWithin, HoldsFarFromTheOrigin) {
  const std::vector<Point> places{{1e9, -9e8}, {1e9, -9e8 + 0.01}, {-1e9, 9e8}};
  EXPECT_EQ(first_within(places, {0, 0, 0}, 0.05), (std::vector<int>{0, 0, 2}));
}

}  // namespace
}  // namespace streetgen
