#include "streetgen/cluster.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "streetgen/error.hpp"

namespace streetgen {

namespace cluster_test {

std::vector<Point> scattered(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> around(0, 1000);
  std::vector<Point> points;
  for (int i = 0; i < count; ++i)
    points.push_back({650000 + 3 * around(random) + (i % 3) * 9000, 6860000 + around(random), 0});
  return points;
}

std::map<int, std::vector<Point>> by_cluster(const std::vector<Point>& points, int k) {
  const std::vector<int> of = clusters(points, k);
  std::map<int, std::vector<Point>> members;
  for (std::size_t i = 0; i < points.size(); ++i) members[of[i]].push_back(points[i]);
  return members;
}

double squares(const std::map<int, std::vector<Point>>& members) {
  double sum = 0;
  for (const auto& [cluster, points] : members) {
    Point centre;
    for (const Point& p : points) centre.x += p.x / points.size(), centre.y += p.y / points.size();
    for (const Point& p : points)
      sum += (p.x - centre.x) * (p.x - centre.x) + (p.y - centre.y) * (p.y - centre.y);
  }
  return sum;
}

TEST(Clusters, AreNumberedAndOfEqualSize) {
  for (const int count : {7, 100, 1001})
    for (const int k : {1, 2, 3, 5, 7}) {
      const auto members = by_cluster(scattered(count, 1), k);
      ASSERT_EQ(static_cast<int>(members.size()), k) << count;
      EXPECT_EQ(members.begin()->first, 1);
      EXPECT_EQ(members.rbegin()->first, k);
      for (const auto& [cluster, points] : members) {
        EXPECT_GE(static_cast<int>(points.size()), count / k);
        EXPECT_LE(static_cast<int>(points.size()), (count + k - 1) / k);
      }
    }
}

// Of two clusters a straight line parts them: at right angles to the line of their centres.
TEST(Clusters, TwoArePartedByALineAcrossTheirCentres) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const auto members = by_cluster(scattered(501, seed), 2);
    Point centre[2];
    for (int c = 0; c < 2; ++c)
      for (const Point& p : members.at(c + 1)) {
        centre[c].x += p.x / members.at(c + 1).size();
        centre[c].y += p.y / members.at(c + 1).size();
      }
    const auto along = [&](const Point& p) {
      return (p.x - centre[0].x) * (centre[1].x - centre[0].x) +
             (p.y - centre[0].y) * (centre[1].y - centre[0].y);
    };
    double last = -1e300, next = 1e300;
    for (const Point& p : members.at(1)) last = std::max(last, along(p));
    for (const Point& p : members.at(2)) next = std::min(next, along(p));
    EXPECT_LE(last, next) << "seed " << seed;
  }
}

// Ranks along x are of equal size too; K-means is more compact.
TEST(Clusters, AreMoreCompactThanStrips) {
  const std::vector<Point> points = scattered(3000, 4);
  std::vector<Point> ranked = points;
  std::sort(ranked.begin(), ranked.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
  std::map<int, std::vector<Point>> strips;
  for (std::size_t i = 0; i < ranked.size(); ++i) strips[i / 150].push_back(ranked[i]);
  EXPECT_LT(squares(by_cluster(points, 20)), squares(strips));
}

TEST(Clusters, PointsInOnePlaceGoByTheirOrder) {
  const std::vector<Point> points(6, Point{5, 5, 0});
  EXPECT_EQ(clusters(points, 3), (std::vector<int>{1, 1, 2, 2, 3, 3}));
}

TEST(Clusters, AreTheSameAgain) {
  const std::vector<Point> points = scattered(2000, 9);
  EXPECT_EQ(clusters(points, 8), clusters(points, 8));
}

TEST(Clusters, KIsWithinOneAndTheNumberOfPoints) {
  const std::vector<Point> points = scattered(4, 2);
  for (const int k : {-1, 0, 5}) EXPECT_THROW(clusters(points, k), Error) << k;
  EXPECT_EQ(clusters(points, 4).size(), 4u);
  EXPECT_THROW(clusters({}, 1), Error);
}

}  // namespace cluster_test
}  // namespace streetgen
