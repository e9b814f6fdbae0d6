#include "interconnection/taut_path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"
#include "interconnection/guided_path.hpp"
#include "interconnection/path_choice.hpp"

namespace streetgen {
namespace taut_path_test {

Ring box(double west, double south, double east, double north) {
  return {{west, south}, {east, south}, {east, north}, {west, north}, {west, south}};
}

// A junction of 60 m by 24 m about the origin, which traffic crosses along x, and an island in it.
class TautPath : public ::testing::Test {
 protected:
  void put(double half_height) {
    place.surface = {{box(-30, -12, 30, 12), reversed(box(-5, -half_height, 5, half_height))}};
  }

  std::optional<Line> path() const {
    const Kerbs kerbs(place.surface, {{{-30, 12}, {-30, -12}}, {{30, 12}, {30, -12}}});
    const LaneEnd in{LaneKind::general, 0, {-30, 0.5}, {1, 0}},
        out{LaneKind::general, 0, {30, 0}, {1, 0}};
    const auto found = taut_path(place, kerbs, 0, 1, in, out, 0.05);
    if (found) {
      EXPECT_FALSE(kerbs.stop(*found, 0, 1));
      EXPECT_TRUE(drivable(*found));
      EXPECT_LT(distance(found->front(), in.place), 1e-9);
      EXPECT_LT(distance(found->back(), out.place), 1e-9);
      EXPECT_NEAR(unit((*found)[1] - found->front()).x, 1, 1e-9);
      EXPECT_NEAR(unit(found->back() - (*found)[found->size() - 2]).x, 1, 1e-9);
    }
    return found;
  }

  // An edge inside along x at that ordinate, whose traffic drives to the right or to the left.
  void drive(double y, bool rightwards) {
    InnerEdge edge;
    edge.line = {{-30, y}, {30, y}};
    edge.along = rightwards;
    edge.against = !rightwards;
    place.inner.push_back(edge);
  }

  static double highest(const Line& line) {
    return std::max_element(line.begin(), line.end(), [](auto& a, auto& b) { return a.y < b.y; })
        ->y;
  }

  JunctionPlace place;
};

TEST_F(TautPath, PassesAnIslandOnTheShorterSide) {
  put(4);
  const auto found = path();
  ASSERT_TRUE(found);
  EXPECT_GT(highest(*found), 4);
  EXPECT_LT(highest(*found), 5.5) << "no farther than a car needs";
}

TEST_F(TautPath, PassesAnIslandWithTheTraffic) {
  put(4);
  drive(8, false);
  drive(-8, true);
  const auto found = path();
  ASSERT_TRUE(found);
  EXPECT_LT(highest(*found), 1);
}

TEST_F(TautPath, PassesAnIslandCloserWhereThereIsLittleRoom) {
  put(11.3);
  EXPECT_TRUE(path());
}

TEST_F(TautPath, IsNoneWhereThereIsNoWay) {
  place.surface = {{box(-30, -12, -5, 12)}, {box(5, -12, 30, 12)}};
  EXPECT_FALSE(path());
}

TEST(KerbBulges, StandOffCornersThatKerbsTurnToTheGround) {
  for (const bool turned : {false, true}) {
    Polygon ground{box(0, 0, 40, 40), reversed(box(10, 10, 20, 20))};
    if (turned)
      for (Ring& ring : ground) ring = reversed(ring);
    const std::vector<Point> places = Kerbs({ground}, {}).bulges(1.2);
    EXPECT_EQ(places.size(), 8u) << "two at each corner of the island, none at those of the border";
    for (const Point& place : places)
      EXPECT_NEAR(std::max({10 - place.x, place.x - 20, 10 - place.y, place.y - 20}), 1.2, 1e-9);
  }
}

// The arc of the first corner ends in the second one, where the path goes straight on.
TEST(RoundedPath, HasNoPieceWithoutDirection) {
  for (int k = 0; k < 60; ++k) {
    const Point ahead{std::cos(0.1 * k), std::sin(0.1 * k), 0};
    const Point aside = (ahead + left_normal(ahead)) * std::sqrt(0.5), from{6.5e5, 6.86e6, 0};
    const Point corner = from + ahead * 20;
    const Line path = rounded(
        {from, corner, corner + aside * 3, corner + aside * 7, corner + aside * 20}, 40, 0.01);
    EXPECT_TRUE(drivable(path)) << k;
    for (std::size_t i = 1; i < path.size(); ++i)
      EXPECT_GT(distance(path[i - 1], path[i]), 1e-5) << k;
  }
}

// A union begins its rings anywhere.
TEST(KerbBulges, AreTheSameWhereverARingBegins) {
  Ring island;
  append_arc(island, {20, 20, 0}, {26, 20, 0}, {20.5, 14.02, 0}, true, 16);
  island.push_back({22, 18, 0});
  std::vector<Point> places;
  for (std::size_t begin = 0; begin < island.size(); ++begin) {
    Ring ring = island;
    std::rotate(ring.begin(), ring.begin() + begin, ring.end());
    ring.push_back(ring.front());
    const auto found = Kerbs({{box(0, 0, 50, 40), reversed(ring)}}, {}).bulges(1.2);
    if (begin == 0) places = found;
    ASSERT_EQ(found.size(), places.size()) << begin;
    for (std::size_t i = 0; i < places.size(); ++i)
      EXPECT_LT(distance(found[i], places[i]), 1e-9) << begin;
  }
}

}  // namespace taut_path_test
}  // namespace streetgen
