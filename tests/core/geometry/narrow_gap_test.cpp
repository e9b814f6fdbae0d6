#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/geos.hpp"
#include "geometry/narrow_gap.hpp"
#include "geometry/polyline.hpp"
#include "rounds.hpp"

namespace streetgen {
namespace narrow_gap_test {

MultiPolygon rectangle(double x, double y, double width, double height) {
  return {
      {{{x, y, 0}, {x + width, y, 0}, {x + width, y + height, 0}, {x, y + height, 0}, {x, y, 0}}}};
}

std::vector<const MultiPolygon*> all(const std::vector<MultiPolygon>& surfaces) {
  std::vector<const MultiPolygon*> out;
  for (const MultiPolygon& surface : surfaces) out.push_back(&surface);
  return out;
}

// Four streets about a block.
std::vector<MultiPolygon> about_a_block(double size) {
  return {rectangle(0, 0, 30, 10), rectangle(0, 10 + size, 30, 10), rectangle(0, 0, 10, 20 + size),
          rectangle(10 + size, 0, 10, 20 + size)};
}

TEST(Narrow, AHoleSmallerThanAskedForIsAPlace) {
  const auto surfaces = about_a_block(0.7);
  const std::vector<Box> places = narrow_gaps(all(surfaces), 0.5);
  ASSERT_EQ(places.size(), 1u);
  EXPECT_TRUE(places[0].holds({10, 10, 0}, 1e-9));
  EXPECT_TRUE(places[0].holds({10.7, 10.7, 0}, 1e-9));
}

// A fifth of a millimetre wide, and a quarter of a micrometre.
TEST(Narrow, AHairIsAPlace) {
  const auto surfaces = about_a_block(0.0);
  EXPECT_TRUE(narrow_gaps(all(surfaces), 0.5).empty());
  for (const double wide : {2e-4, 2.5e-7}) {
    std::vector<MultiPolygon> hair{rectangle(0, 0, 30, 10), rectangle(0, 10 + wide, 30, 10),
                                   rectangle(0, 0, 10, 20), rectangle(11, 0, 19, 20)};
    EXPECT_EQ(narrow_gaps(all(hair), 0.5).size(), 1u) << wide;
  }
}

// A crack in the lower surface, longer than the rest of the hole's border, ends at the hole.
TEST(Narrow, AHoleMayEndInACrackOfASurface) {
  const MultiPolygon upper{{{{0, 10, 0},
                             {4.9, 10, 0},
                             {5, 10.1, 0},
                             {5.1, 10, 0},
                             {10, 10, 0},
                             {5, 20, 0},
                             {0, 10, 0}}}};
  for (const double wide : {1e-9, 1e-7}) {
    const MultiPolygon lower{{{{0, 0, 0},
                               {10, 0, 0},
                               {10, 10, 0},
                               {5 + wide, 10, 0},
                               {5, 2, 0},
                               {5, 10, 0},
                               {0, 10, 0},
                               {0, 0, 0}}}};
    const std::vector<MultiPolygon> surfaces{lower, upper};
    const std::vector<Box> places = narrow_gaps(all(surfaces), 0.5);
    ASSERT_EQ(places.size(), 1u) << wide;
    EXPECT_TRUE(places[0].holds({5, 10.1, 0}, 1e-9));
  }
}

TEST(Narrow, AWideHoleIsNone) {
  const auto surfaces = about_a_block(5);
  EXPECT_TRUE(narrow_gaps(all(surfaces), 0.5).empty());
}

TEST(Narrow, AGapThatIsOpenIsNone) {
  EXPECT_TRUE(narrow_gaps(all({rectangle(0, 0, 10, 10), rectangle(10.1, 0, 10, 10)}), 0.5).empty());
  EXPECT_TRUE(
      narrow_gaps(
          all({rectangle(0, 0, 10, 10), rectangle(10.1, 0, 10, 10), rectangle(5, 8, 10, 10)}), 0.5)
          .empty());
}

TEST(Narrow, SurfacesThatShareABorderLeaveNone) {
  EXPECT_TRUE(narrow_gaps(all({rectangle(0, 0, 10, 10), rectangle(10, 0, 10, 10),
                               rectangle(20, 2, 10, 6), rectangle(10, 10, 10, 30)}),
                          0.5)
                  .empty());
}

// The two parts of the first surface touch at (10, 10), where a hole against the second one ends.
TEST(Narrow, AHoleMayEndWhereASurfaceTouchesItself) {
  MultiPolygon parts = rectangle(0, 0, 10, 10);
  parts.push_back(rectangle(10, 10, 10, 10)[0]);
  const MultiPolygon beside{
      {{{10, 0, 0}, {20, 0, 0}, {20, 10, 0}, {10.5, 10, 0}, {10, 9.5, 0}, {10, 0, 0}}}};
  const std::vector<MultiPolygon> surfaces{parts, beside};
  const std::vector<Box> places = narrow_gaps(all(surfaces), 0.5);
  ASSERT_EQ(places.size(), 1u);
  EXPECT_TRUE(places[0].holds({10, 10, 0}, 1e-9));
}

TEST(Narrow, EverySmallHoleOfAUnionIsInAPlace) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(0, 40), turn(0, M_PI), long_side(10, 40),
      short_side(3, 8);
  Geos geos;
  constexpr double max_area = 4;
  int holes = 0;
  for (int round = 0; round < rounds(400); ++round) {
    std::vector<MultiPolygon> surfaces;
    for (int i = 0; i < 12; ++i) {
      const double angle = round % 3 == 0 ? M_PI / 2 * (i % 2) : turn(random);
      const Point at{650000 + place(random), 6860000 + place(random), 0};
      const Point along = Point{std::cos(angle), std::sin(angle), 0} * long_side(random);
      const Point across = left_normal(unit(along)) * short_side(random);
      surfaces.push_back({{{at, at + along, at + along + across, at + across, at}}});
    }
    const std::vector<Box> places = narrow_gaps(all(surfaces), max_area);
    for (const Polygon& polygon : geos.polygons(geos.unite(surfaces).get()))
      for (std::size_t i = 1; i < polygon.size(); ++i) {
        if (std::abs(signed_area(polygon[i])) >= max_area) continue;
        ++holes;
        const Box hole = box_of({{polygon[i]}});
        EXPECT_TRUE(std::any_of(places.begin(), places.end(), [&](const Box& box) {
          return box.holds({hole.min_x, hole.min_y, 0}, 1e-6) &&
                 box.holds({hole.max_x, hole.max_y, 0}, 1e-6);
        })) << round;
      }
  }
  EXPECT_GT(holes, rounds(100));
}

}  // namespace narrow_gap_test
}  // namespace streetgen
