#include "ownership/slit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "geometry/geos.hpp"
#include "geometry/polyline.hpp"
#include "streetgen/lane.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {
namespace slit_test {

StreetAxis axis(std::int64_t id, Line line, int level = 0) {
  return {id, std::move(line), level, 6, 6, 4, 3};
}

double ground_of(const Streets& town) {
  double sum = 0;
  for (const Section& section : town.sections) sum += area(section.surface);
  for (const Intersection& intersection : town.intersections) sum += area(intersection.surface);
  return sum;
}

double united_ground(const Streets& town) {
  Geos geos;
  std::vector<MultiPolygon> all;
  for (const Section& section : town.sections) all.push_back(section.surface);
  for (const Intersection& intersection : town.intersections) all.push_back(intersection.surface);
  return area(geos.polygons(geos.unite(all).get()));
}

StreetSettings with_slits_up_to(double width) {
  StreetSettings settings;
  settings.slit_width = width;
  settings.kerb_radius_minimal = 0;  // the corners of streets that cross stay sharp
  return settings;
}

TEST(Slit, BetweenParallelStreetsIsRoadway) {
  const std::vector<StreetAxis> beside{axis(1, {{0, 0, 0}, {100, 0, 0}}),
                                       axis(2, {{20, 6.15, 0}, {80, 6.15, 0}})};
  const Streets town = streets(beside, with_slits_up_to(0.2));
  EXPECT_NEAR(ground_of(town), 160 * 6 + 60 * 0.15, 1e-6);
  EXPECT_NEAR(united_ground(town), ground_of(town), 1e-6);
  EXPECT_NEAR(ground_of(streets(beside, with_slits_up_to(0))), 160 * 6, 1e-6);
  EXPECT_NEAR(ground_of(streets(beside, with_slits_up_to(0.1))), 160 * 6, 1e-6);
}

// Three streets about a triangle of 2 or 8 m2.
double enclosed_ground(double area, double island_area_minimal) {
  StreetSettings settings;
  settings.island_area_minimal = island_area_minimal;
  settings.kerb_radius_minimal = 0;
  const double within = std::sqrt(area / (3 * std::sqrt(3))),
               side = 2 * std::sqrt(3) * (within + 3);
  const Point a{0, 0, 0}, b{side, 0, 0}, c{side / 2, side * std::sqrt(3) / 2, 0};
  std::vector<StreetAxis> about{axis(1, {a, b}), axis(2, {b, c}), axis(3, {c, a})};
  for (StreetAxis& one : about) one.radius = 0;
  return united_ground(streets(about, settings));
}

TEST(Hole, IsRoadwayWhereNobodyBuildsAnIsland) {
  EXPECT_NEAR(enclosed_ground(2, 3.5) - enclosed_ground(2, 0), 2, 1e-6);
  EXPECT_NEAR(enclosed_ground(8, 3.5) - enclosed_ground(8, 0), 0, 1e-6);
  EXPECT_NEAR(enclosed_ground(8, 9) - enclosed_ground(8, 0), 8, 1e-6);
}

TEST(Slit, EndsWhereTheStreetsAreFartherApart) {
  // 0.1 m apart at one end, 3.1 m at the other.
  const std::vector<StreetAxis> apart{axis(1, {{0, 0, 0}, {100, 0, 0}}),
                                      axis(2, {{0, 6.1, 0}, {100, 9.1, 0}})};
  const double gained = ground_of(streets(apart, with_slits_up_to(0.2))) -
                        ground_of(streets(apart, with_slits_up_to(0)));
  // A trapezium from 0.1 to 0.2 m, 3 % steep; both kerbs as they lie beside flat ends.
  EXPECT_NEAR(gained, 0.15 * 0.1 / 0.03, 0.05);
}

TEST(Slit, OfABentStreetIsWhole) {
  const Line bent{{0, 0, 0}, {50, 0, 0}, {100, 8, 0}};
  Line beside = offset_line(bent, 6.1, 6.1);
  const std::vector<StreetAxis> both{axis(1, bent), axis(2, beside)};
  const Streets town = streets(both, with_slits_up_to(0.2));
  const double gained = ground_of(town) - ground_of(streets(both, with_slits_up_to(0)));
  EXPECT_NEAR(gained, 0.1 * length(offset_line(bent, 3.05, 3.05)), 0.02);
  EXPECT_NEAR(united_ground(town), ground_of(town), 1e-6);
}

TEST(Slit, StaysBetweenLevelsAndWhereAnotherStreetLies) {
  const StreetAxis low = axis(1, {{0, 0, 0}, {100, 0, 0}}),
                   high = axis(2, {{0, 6.1, 0}, {100, 6.1, 0}}, 1);
  EXPECT_NEAR(ground_of(streets({low, high}, with_slits_up_to(0.2))), 1200, 1e-6);
  const StreetAxis across = axis(3, {{50, -30, 0}, {50, 40, 0}});
  const StreetAxis beside = axis(2, {{0, 6.1, 0}, {100, 6.1, 0}});
  const Streets crossed = streets({low, beside, across}, with_slits_up_to(0.2));
  EXPECT_NEAR(united_ground(crossed), ground_of(crossed), 1e-5);
  EXPECT_NEAR(ground_of(crossed), 1200 + 94 * 0.1 + 6 * 70 - 6 * 12, 1e-5);
}

// Two side streets 7 m apart: the limits between their nodes cross, and so do their corners' arcs,
// where these have no bound.
TEST(Notch, BetweenCornersOfNeighboursIsRound) {
  const std::vector<StreetAxis> beside = {
      axis(1, {{0, 0, 0}, {50, 0, 0}}), axis(2, {{50, 0, 0}, {57, 0, 0}}),
      axis(3, {{57, 0, 0}, {100, 0, 0}}), axis(4, {{50, 0, 0}, {50, 40, 0}}),
      axis(5, {{57, 0, 0}, {57, 40, 0}})};
  StreetSettings settings = with_slits_up_to(0.2);
  settings.island_area = 0;
  settings.corner_length = std::numeric_limits<double>::infinity();
  for (const double radius : {0.2, 0.4}) {
    settings.kerb_radius_minimal = 0;
    std::vector<StreetAxis> axes = beside;
    for (StreetAxis& a : axes) a.radius = 4;
    const double sharp = ground_of(streets(axes, settings));
    settings.kerb_radius_minimal = radius;
    const Streets round = streets(axes, settings);
    EXPECT_GT(ground_of(round) - sharp, 0.001);
    EXPECT_LT(ground_of(round) - sharp, 1);
    EXPECT_NEAR(united_ground(round), ground_of(round), 1e-5);
  }
}

TEST(Slit, IsTheSameWhereverTheStreetsLie) {
  for (const double turn : {0.3, 1.1, 2.9}) {
    const auto at = [&](double x, double y) {
      return Point{650000 + x * std::cos(turn) - y * std::sin(turn),
                   6860000 + x * std::sin(turn) + y * std::cos(turn), 0};
    };
    const Streets town =
        streets({axis(1, {at(0, 0), at(100, 0)}), axis(2, {at(20, 6.15), at(80, 6.15)})},
                with_slits_up_to(0.2));
    EXPECT_NEAR(ground_of(town), 160 * 6 + 60 * 0.15, 1e-4);
    EXPECT_NEAR(united_ground(town), ground_of(town), 1e-4);
  }
}

}  // namespace slit_test
}  // namespace streetgen
