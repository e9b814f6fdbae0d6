#include "ownership/claim_index.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "geometry/polyline.hpp"
#include "layout/node_corner.hpp"
#include "ownership/hole.hpp"

namespace streetgen {
namespace claim_index_test {

class RandomNode {
 public:
  explicit RandomNode(unsigned seed) : random_(seed) {
    const int degree = 2 + static_cast<int>(random_() % 4);
    std::vector<Arm> arms;
    for (int i = 0; i < degree; ++i) arms.push_back(arm());
    for (const std::size_t i : counter_clockwise(arms)) arms_.push_back(arms[i]);
    for (std::size_t i = 0; i < arms_.size(); ++i) {
      Arm &a = arms_[i], &b = arms_[(i + 1) % arms_.size()];
      const SolvedCorner corner = solve_corner(a, b, {number(0, 12)});
      widen_limits(a, b, corner);
      gaps_.push_back(corner.gap);
    }
    for (Arm& arm : arms_) arm.border = border_across(arm, arm.limit);
  }
  const std::vector<Arm>& arms() const { return arms_; }
  const std::vector<Gap>& gaps() const { return gaps_; }

 private:
  double number(double from, double to) {
    return from + (to - from) * static_cast<double>(random_() % 100000) / 100000;
  }
  Arm arm() {
    Line line{{0, 0, 0}};
    double angle = number(0, 2 * M_PI);
    for (int i = 0; i < 3; ++i) {
      const double length = number(3, 30);
      line.push_back(line.back() + Point{std::cos(angle), std::sin(angle), 0} * length);
      angle += number(-1, 1);
    }
    const double half = number(1, 8);
    return {line, half, half, 0, {}};
  }
  std::mt19937_64 random_;
  std::vector<Arm> arms_;
  std::vector<Gap> gaps_;
};

bool holds(const Extent& extent, const Point& p) {
  return extent.box.holds(p, 0) && std::any_of(extent.parts.begin(), extent.parts.end(),
                                               [&](const Box& part) { return part.holds(p, 0); });
}

// Every decimetre of its boundary.
bool holds(const Extent& extent, const MultiPolygon& surface) {
  for (const Polygon& polygon : surface)
    for (const Ring& ring : polygon)
      for (std::size_t i = 1; i < ring.size(); ++i) {
        const double pieces = std::ceil(10 * distance(ring[i - 1], ring[i]));
        for (double k = 0; k <= pieces; ++k)
          if (!holds(extent, ring[i - 1] + (ring[i] - ring[i - 1]) * (k / std::max(1.0, pieces))))
            return false;
      }
  return true;
}

TEST(Vicinity, AnExtentHoldsTheSurfaceThatIsBuilt) {
  Geos geos;
  for (unsigned seed = 1; seed <= 300; ++seed) {
    const RandomNode node(seed);
    EXPECT_TRUE(holds(intersection_extent(node.arms(), node.gaps()),
                      build_intersection(geos, node.arms(), node.gaps()).surface))
        << "seed " << seed;
    for (const Arm& arm : node.arms()) {
      const double start = length(arm.line) / 4, end = length(arm.line) / 2;
      const Built section = build_section(geos, arm, {}, start, end, border_across(arm, start),
                                          border_across(arm, end), {});
      EXPECT_TRUE(holds(section_extent(arm, start, end), section.surface)) << "seed " << seed;
    }
  }
}

// Not its box: a long street that runs askew has most of that to itself.
TEST(Vicinity, AnExtentLeavesOutWhatLiesFarFromTheAxis) {
  const Extent street = section_extent({{{0, 0, 0}, {300, 300, 0}}, 4, 4, 0, {}}, 0, 400);
  EXPECT_FALSE(holds(street, {200, 100, 0}));
}

Extent from_to(double min_x, double min_y, double max_x, double max_y) {
  Extent extent;
  extent.add({min_x, min_y, max_x, max_y});
  return extent;
}

TEST(Vicinity, OpponentsMeetTheClaimAndTileWithIt) {
  std::vector<Claim> claims(4);
  claims[2].level = 1;
  for (int i = 0; i < 4; ++i) claims[i].edges = {i};
  Vicinity vicinity(
      {from_to(0, 0, 2, 2), from_to(1, 1, 3, 3), from_to(1, 1, 3, 3), from_to(2.5, 2.5, 4, 4)},
      claims, 0);
  EXPECT_EQ(vicinity.opponents(0), std::vector<int>{1});
  EXPECT_EQ(vicinity.opponents(1), (std::vector<int>{0, 3}));
  EXPECT_EQ(vicinity.opponents(2), std::vector<int>{});
  claims[0].joins_levels = true;
  EXPECT_EQ(vicinity.opponents(1), (std::vector<int>{0, 2, 3}));
}

// About the first claim: two neighbours with a third behind both, and behind one of them a row of
// others that leads nowhere.
TEST(Vicinity, OnlyWhatMeetsTwoNeighboursEnclosesAHole) {
  const std::vector<Claim> claims(6);
  const std::vector<bool> none(6);
  Vicinity vicinity({from_to(0, 0, 9, 1), from_to(0, 1, 1, 5), from_to(8, 1, 9, 5),
                     from_to(0, 5, 9, 6), from_to(4, -3, 5, 0), from_to(4, -6, 5, -3)},
                    claims, 0);
  EXPECT_EQ(vicinity.enclosing(0, none), (std::vector<int>{1, 2, 3}));
}

// Beyond the extent of a hole from the claim nothing closes a ring about one beside it.
TEST(Vicinity, WhatEnclosesAHoleIsNear) {
  const std::vector<Claim> claims(4);
  const std::vector<bool> none(4);
  const double far = 1 + hole_extent;
  const auto ring = [&](double y) {
    return std::vector<Extent>{from_to(0, 0, 9, 1), from_to(0, 1, 1, y), from_to(8, 1, 9, y),
                               from_to(0, y, 9, y + 1)};
  };
  EXPECT_EQ(Vicinity(ring(far - 1), claims, 0).enclosing(0, none), (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(Vicinity(ring(far + 1), claims, 0).enclosing(0, none), std::vector<int>{});
}

}  // namespace claim_index_test
}  // namespace streetgen
