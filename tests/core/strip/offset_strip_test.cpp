#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/geos.hpp"
#include "geometry/polyline.hpp"
#include "streetgen/surface.hpp"

namespace streetgen {
namespace offset_strip_test {

CurvedLine arc(const Point& start, const Point& middle, const Point& end) {
  return {{{start, middle, end}, true}};
}

TEST(OffsetStrip, OfAStraightKerbIsATrapezoidOnItsLeft) {
  const MultiPolygon strip = offset_strip(Line{{0, 0, 0}, {10, 0, 0}, {30, 0, 0}}, 2, 5);
  EXPECT_NEAR(area(strip), 30 * 3.5, 1e-9);
  ASSERT_EQ(strip.size(), 1u);
  for (const Point& p : strip.front().front()) EXPECT_GE(p.y, 0);
}

TEST(OffsetStrip, IsRoundAboutAnOuterBend) {
  const MultiPolygon strip = offset_strip(Line{{0, 0, 0}, {20, 0, 0}, {20, -20, 0}}, 2, 2);
  // The quarter disc in eight chords.
  EXPECT_NEAR(area(strip), 2 * 20 * 2 + 8 * std::sin(M_PI / 16) * 4 / 2, 1e-9);
}

// Of a quarter circle the strip is a quarter of a ring. Its ends are square to the first and the
// last chord: each turns by half the angle of a chord that leaves the arc by a millimetre.
TEST(OffsetStrip, OfAnArcIsPartOfARing) {
  const double r = 5, root = std::sqrt(0.5), turn = std::acos(1 - 1e-3 / r);
  const MultiPolygon outside =
      offset_strip(arc({-r, 0, 0}, {-r * root, r * root, 0}, {0, r, 0}), 2, 2);
  EXPECT_NEAR(area(outside), M_PI / 4 * (49 - 25), turn * (49 - 25));
  const MultiPolygon inside =
      offset_strip(arc({0, r, 0}, {-r * root, r * root, 0}, {-r, 0, 0}), 2, 2);
  EXPECT_NEAR(area(inside), M_PI / 4 * (25 - 9), turn * (25 - 9));
}

TEST(OffsetStrip, OfACircleIsARingOrADisc) {
  const CurvedLine circle{{{{5, 0, 0}, {-5, 0, 0}, {5, 0, 0}}, true}};
  EXPECT_NEAR(area(offset_strip(circle, 2, 2)), M_PI * (25 - 9), 0.05);
  EXPECT_NEAR(area(offset_strip(circle, 7, 7)), M_PI * 25, 0.05);
}

TEST(OffsetStrip, IsEmptyWithoutWidth) {
  EXPECT_TRUE(offset_strip(Line{{0, 0, 0}, {10, 0, 0}}, 0, 0).empty());
  EXPECT_NEAR(area(offset_strip(Line{{0, 0, 0}, {10, 0, 0}}, 0, 2)), 10, 1e-9);
}

TEST(OffsetStrip, IsValidOnRoughKerbs) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> step(-6, 6), width(0, 8);
  Geos geos;
  for (int i = 0; i < 300; ++i) {
    Line kerb{{0, 0, 0}};
    for (int k = 0; k < 8; ++k)
      kerb.push_back(kerb.back() + Point{3 + step(random), step(random), 0});
    const MultiPolygon strip = offset_strip(kerb, width(random), width(random));
    EXPECT_TRUE(geos.valid(strip)) << i;
    EXPECT_GT(area(strip), 0) << i;
  }
}

// A piece of a micrometre has no direction but the noise of its coordinates.
TEST(OffsetStrip, TakesNoDirectionFromAPieceOfAMicrometre) {
  const double plain = area(offset_strip(Line{{0, 0, 0}, {8, 3, 0}, {11, 3, 0}}, 0.3, 0.3));
  for (int k = 0; k < 16; ++k) {
    const double t = k * M_PI / 8;
    const Point off{1e-6 * std::cos(t), 1e-6 * std::sin(t), 0};
    const Line noisy{{0, 0, 0}, {8, 3, 0}, Point{8, 3, 0} + off, {11, 3, 0}};
    EXPECT_NEAR(area(offset_strip(noisy, 0.3, 0.3)), plain, 4e-5) << k;
    EXPECT_NEAR(area(offset_strip(Line{off, {0, 0, 0}, {8, 3, 0}, {11, 3, 0}}, 0.3, 0.3)), plain,
                4e-5)
        << k;
  }
}

// A kerb that begins with a centimetre square to it: no strip of a centimetre lies along all of it.
TEST(OffsetStrip, LiesAlongAKerbBehindASquareStep) {
  for (const double off : {-1e-4, -1e-6, -1e-9, 0.0, 1e-9, 1e-6, 1e-4}) {
    const double step = 0.012;
    const Line kerb{{step * std::sin(off), step * std::cos(off), 0}, {0, 0, 0}, {4, 0, 0}};
    EXPECT_NEAR(area(offset_strip(kerb, 0.3, 0.3)), 4 * 0.3, 1e-4) << off;
    const Line end{{-4, 0, 0}, {0, 0, 0}, {step * std::sin(off), step * std::cos(off), 0}};
    EXPECT_NEAR(area(offset_strip(end, 0.3, 0.3)), 4 * 0.3, 1e-4) << off;
  }
}

TEST(OffsetStrip, LiesBehindALineOfNothingButMicrometres) {
  const MultiPolygon strip = offset_strip(Line{{0, 0, 0}, {2e-6, 0, 0}, {0, 0, 0}}, 0.3, 0.3);
  EXPECT_TRUE(Geos().valid(strip));
}

}  // namespace offset_strip_test
}  // namespace streetgen
