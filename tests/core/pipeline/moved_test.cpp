// Streets do not turn with the paper.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "geometry/polyline.hpp"
#include "rounds.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {
namespace moved_test {

const Point centre{340000, 4830000, 0};

Point turned(const Point& p, double radians) {
  const Point off = p - centre;
  return centre + Point{off.x * std::cos(radians) - off.y * std::sin(radians),
                        off.x * std::sin(radians) + off.y * std::cos(radians), 0};
}

std::vector<StreetAxis> turned(std::vector<StreetAxis> axes, double radians) {
  for (StreetAxis& axis : axes)
    for (Point& p : axis.line) p = turned(p, radians);
  return axes;
}

// The area of each intersection, with its node.
struct Ground {
  Point node;
  double area;
};

std::vector<Ground> grounds_of(const std::vector<StreetAxis>& axes) {
  StreetSettings settings;
  settings.kerb_radius_minimal = 0;
  const Streets town = streets(axes, settings);
  std::vector<Ground> grounds;
  for (const Intersection& intersection : town.intersections)
    grounds.push_back({town.network.nodes[intersection.node].point, area(intersection.surface)});
  return grounds;
}

void expect_same(const std::vector<Ground>& grounds, const std::vector<Ground>& moved,
                 double radians, const std::string& which) {
  ASSERT_EQ(grounds.size(), moved.size()) << which;
  for (const Ground& ground : grounds) {
    const Point place = turned(ground.node, radians);
    const auto nearest =
        std::min_element(moved.begin(), moved.end(), [&](const Ground& a, const Ground& b) {
          return distance(a.node, place) < distance(b.node, place);
        });
    EXPECT_NEAR(ground.area, nearest->area, 2e-5) << which;
  }
}

Point place_on(const Point& from, double degrees, double metres) {
  const double radians = degrees * M_PI / 180;
  return from + Point{metres * std::cos(radians), metres * std::sin(radians), 0};
}

// Limits that cross meet in the middle between two nodes, on a border line that the ground of both
// intersections and the border between their owners have in common.
TEST(MovedStreets, ForksBesideEachOtherDivideTheirGroundAlikeHoweverTurned) {
  for (int seed = 1; seed <= rounds(40); ++seed) {
    std::mt19937_64 random(seed);
    const auto degrees = [&](double least, double most) {
      return least + (most - least) * static_cast<double>(random() % 1000) / 1000;
    };
    const Point a = centre, b = place_on(a, degrees(0, 360), 3 + degrees(0, 2));
    const double on = std::atan2(b.y - a.y, b.x - a.x) * 180 / M_PI;
    const std::vector<StreetAxis> axes{
        {1, {place_on(a, on + degrees(90, 130), 60), a}, 0, 4, 4, 3},
        {2, {a, b, place_on(b, on + degrees(-10, 10), 80)}, 0, 4, 4, 3},
        {3, {a, place_on(a, on + degrees(-110, -50), 50)}, 0, 4, 4, 3},
        {4, {place_on(b, on + degrees(-110, -50), 40), b}, 0, 4, 4, 3}};
    const std::vector<Ground> grounds = grounds_of(axes);
    for (int k = 1; k < 12; ++k)
      expect_same(grounds, grounds_of(turned(axes, 0.53 * k)), 0.53 * k,
                  "seed " + std::to_string(seed) + ", turn " + std::to_string(k));
  }
}

// Whether a ring goes along a crack and back.
bool has_crack(const Ring& ring) {
  for (std::size_t i = 1; i < ring.size(); ++i) {
    const Point &before = ring[i - 1], &tip = ring[i],
                &after = ring[i + 1 < ring.size() ? i + 1 : 1];
    const double least = std::min(distance(before, tip), distance(tip, after));
    if (least > 0.01 && dot(tip - before, after - tip) < 0 &&
        std::min(distance_to_segment(after, before, tip),
                 distance_to_segment(before, tip, after)) < 1e-6)
      return true;
  }
  return false;
}

void expect_no_cracks(const std::vector<StreetAxis>& axes) {
  for (int k = 0; k < 60; ++k)
    for (const Intersection& intersection : streets(turned(axes, 0.11 * k), {}).intersections)
      for (const Polygon& polygon : intersection.surface)
        for (const Ring& ring : polygon) EXPECT_FALSE(has_crack(ring)) << "turn " << k;
}

// The pieces of the narrower street and those between both share a side from different ends.
TEST(MovedStreets, HaveNoCrackWhereAStreetNarrowsAtAFork) {
  const auto place = [](double x, double y) { return centre + Point{x, y, 0}; };
  const std::vector<StreetAxis> axes{
      {1, {place(0, 0), place(-0.5, 16.2), place(-0.5, 28)}, 0, 8, 8, 6.25, 3, 70},
      {2, {place(4.4, -63), place(2.5, -36), place(0, 0)}, 0, 10.5, 10.5, 6.25, 3, 70},
      {3, {place(0, 0), place(3.8, 8), place(6.5, 14.2), place(15.8, 23.5)}, 0, 3.5, 3.5, 6.25, 3}};
  expect_no_cracks(axes);
}

// What is filled between carriageways begins amid the side of a surface.
TEST(MovedStreets, HaveNoCrackWhereTheGroundBetweenCarriagewaysIsFilled) {
  const auto place = [](double x, double y) { return centre + Point{x, y, 0}; };
  expect_no_cracks({{1, {place(-180, 0), place(0, 0)}, 0, 11, 11, 8, 1, 90},
                    {2, {place(0, 0), place(300, 0)}, 0, 11, 11, 8, 1, 90},
                    {3, {place(300, 12), place(0, 12)}, 0, 11, 11, 8, 1, 90},
                    {4, {place(0, 12), place(-180, 12)}, 0, 11, 11, 8, 1, 90},
                    {5, {place(2, -140), place(0, 0)}, 0, 9, 9, 6.25, 3, 50},
                    {6, {place(0, 0), place(0, 12)}, 0, 9, 9, 6.25, 3, 50},
                    {7, {place(0, 12), place(1, 90)}, 0, 9, 9, 6.25, 3, 50}});
}

// Part of a street drawn again as another, as wide: nothing but the axes' lengths tells which lies
// on which side.
TEST(MovedStreets, ThatAreDrawnTwiceLieAlikeUnderAnyNumbers) {
  const auto place = [](double along) { return centre + Point{along, 0.3 * along, 0}; };
  std::vector<std::int64_t> numbers{1, 2, 3, 4};
  std::vector<Ground> grounds;
  do {
    const std::vector<StreetAxis> axes{
        {numbers[0], {place(0), place(40), place(200)}, 0, 7, 7, 6, 3},
        {numbers[1], {place(40), place(150)}, 0, 7, 7, 6, 3},
        {numbers[2], {place(40), place(40) + Point{-10, 60, 0}}, 0, 7, 7, 6, 3},
        {numbers[3], {place(150), place(150) + Point{30, -50, 0}}, 0, 7, 7, 6, 3}};
    if (grounds.empty()) grounds = grounds_of(axes);
    expect_same(grounds, grounds_of(axes), 0, std::to_string(numbers[0]));
  } while (std::next_permutation(numbers.begin(), numbers.end()));
}

}  // namespace moved_test
}  // namespace streetgen
