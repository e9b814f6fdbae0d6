// What rounding must not decide of the strips behind kerbs.
#include "sidewalk/strip.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/polyline.hpp"

namespace streetgen {
namespace strip_test {

SidewalkKerb kerb(const Line& line, std::optional<double> width) {
  SidewalkKerb made;
  made.line = line;
  made.width = width;
  return made;
}

// On the paper of a country.
Line turned(Line line, double radians) {
  for (Point& p : line)
    p = {6.5e5 + p.x * std::cos(radians) - p.y * std::sin(radians),
         6.86e6 + p.x * std::sin(radians) + p.y * std::cos(radians), 0};
  return line;
}

void expect_plain(const std::vector<SidewalkKerb>& kerbs, const std::vector<double>& areas) {
  for (int k = 0; k < 24; ++k) {
    std::vector<SidewalkKerb> placed = kerbs;
    for (SidewalkKerb& each : placed) each.line = turned(each.line, 0.37 * k);
    const std::vector<Strip> strips = strips_behind(placed, KerbChains(placed, 5));
    for (std::size_t i = 0; i < areas.size(); ++i) {
      EXPECT_TRUE(strips[i].plain) << k << ", kerb " << i;
      EXPECT_NEAR(area(strips[i].surface), areas[i], 1e-6) << k << ", kerb " << i;
    }
  }
}

// The fronts of a triangle meet in one place, whichever of the three is looked at first.
TEST(Strip, OfATriangleGoesToItsMiddle) {
  const Line corners{{0, 0, 0}, {7, 0.5, 0}, {3, 4, 0}, {0, 0, 0}};
  std::vector<SidewalkKerb> kerbs;
  double around = 0;
  for (int i = 0; i < 3; ++i) {
    kerbs.push_back(kerb({corners[i], corners[i + 1]}, 3));
    around += length(kerbs[i].line);
  }
  std::vector<double> areas;
  for (const SidewalkKerb& each : kerbs)
    areas.push_back(signed_area(corners) * length(each.line) / around);
  expect_plain(kerbs, areas);
}

// The way along the bisector leads to the place where both back lines meet, and to neither first.
TEST(Strip, InAWedgeEndsWhereBothBackLinesMeet) {
  for (const double degrees : {12.0, 25.0, 37.0, 52.0}) {
    const double wedge = degrees * M_PI / 180, width = 2.5;
    const Point tip{-30 * std::cos(wedge), 30 * std::sin(wedge), 0};
    const std::vector<SidewalkKerb> kerbs{kerb({{-30, 0, 0}, {0, 0, 0}}, width),
                                          kerb({{0, 0, 0}, tip}, width)};
    const double each = width * 30 - width * width / std::tan(wedge / 2) / 2;
    expect_plain(kerbs, {each, each});
  }
}

// A piece of a tenth of a micrometre where an arc ends has no direction but noise.
TEST(Strip, TakesNoDirectionFromNoise) {
  Line arc{{0, 0, 0}};
  append_arc(arc, {0, 4, 0}, arc[0], {4, 4, 0}, true, 16);
  arc.push_back({4, 4, 0});
  const auto behind = [&](const Line& line) {
    return find_sidewalks({kerb({{-20, 0, 0}, {0, 0, 0}}, 3), kerb(line, std::nullopt),
                           kerb({{4, 4, 0}, {4, 30, 0}}, 1.5)},
                          5);
  };
  const auto plain = behind(arc);
  for (int k = 0; k < 16; ++k) {
    Line noisy = arc;
    noisy.back() = noisy.back() + Point{1e-7 * std::cos(k), 1e-7 * std::sin(k), 0};
    noisy.push_back(arc.back());
    const auto sidewalks = behind(noisy);
    ASSERT_EQ(sidewalks.size(), 3u) << k;
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(sidewalks[i].method, Method::hypothesis) << k;
      EXPECT_NEAR(area(sidewalks[i].surface), area(plain[i].surface), 1e-5) << k;
    }
  }
}

}  // namespace strip_test
}  // namespace streetgen
