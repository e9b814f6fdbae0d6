#include "roadway/section_taper.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/geos.hpp"
#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "streetgen/lane.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {
namespace section_taper_test {

StreetAxis axis(std::int64_t id, Line line, double width, double speed) {
  StreetAxis made{id, std::move(line), 0, width, width, 4, 3};
  made.speed = speed;
  return made;
}

// A street along x that becomes 6 m wider where another one leaves to the south.
std::vector<StreetAxis> widening(double speed, bool turned = false) {
  Line west{{-100, 0, 0}, {0, 0, 0}}, east{{0, 0, 0}, {100, 0, 0}};
  if (turned) {
    std::reverse(west.begin(), west.end());
    std::reverse(east.begin(), east.end());
  }
  return {axis(1, west, 6, speed), axis(2, east, 12, speed),
          axis(3, {{0, 0, 0}, {0, -60, 0}}, 6, speed)};
}

std::vector<MultiPolygon> surfaces_of(const Streets& town) {
  std::vector<MultiPolygon> all;
  for (const Section& section : town.sections) all.push_back(section.surface);
  for (const Intersection& intersection : town.intersections) all.push_back(intersection.surface);
  return all;
}

double ground_of(const Streets& town) {
  double sum = 0;
  for (const MultiPolygon& surface : surfaces_of(town)) sum += area(surface);
  return sum;
}

// 20 m along the street for each metre aside from 70 km/h on: 60 m, 30 on each edge.
constexpr double fast = 80, reach = 30;

TEST(SectionTaper, GoesOnBeyondTheLimits) {
  for (const bool turned : {false, true}) {
    const Streets town = streets(widening(fast, turned), {});
    int on_taper = 0;
    for (const MultiPolygon& surface : surfaces_of(town))
      for (const Point& p : surface.front().front()) {
        if (p.y <= 2) continue;
        const double half = std::clamp(4.5 + p.x * 3 / (2 * reach), 3.0, 6.0);
        EXPECT_NEAR(p.y, half, 1e-9) << p.x;
        if (std::abs(p.x) <= reach + 1e-9) ++on_taper;
      }
    EXPECT_GE(on_taper, 6);  // both ends of it, and the limits of two surfaces each
  }
}

TEST(SectionTaper, LeavesLimitsAndTheOtherKerb) {
  const Streets slow = streets(widening(30), {}), town = streets(widening(fast), {});
  for (std::size_t l = 0; l < town.limits.size(); ++l)
    EXPECT_EQ(town.limits[l].abscissa, slow.limits[l].abscissa);
  for (const Section& section : town.sections) {
    if (section.edge == 2) continue;
    double lowest = 0;
    for (const Point& p : section.surface.front().front()) lowest = std::min(lowest, p.y);
    EXPECT_NEAR(lowest, section.edge == 0 ? -3 : -6, 1e-9);
  }
}

TEST(SectionTaper, TilesWithLanes) {
  for (const bool turned : {false, true}) {
    const Streets town = streets(widening(fast, turned), {});
    Geos geos;
    EXPECT_NEAR(area(geos.polygons(geos.unite(surfaces_of(town)).get())), ground_of(town), 1e-9);
    std::vector<double> sum(town.sections.size());
    const std::vector<LanesOfAxis> wished{{1, {{{}}, {{}}}}, {2, {{{}, {}}, {{}, {}}}}};
    for (const Lane& lane : lanes(town, wished, {}, {}).lanes) {
      EXPECT_TRUE(geos.valid(lane.surface));
      sum[lane.edge] += area(lane.surface);
    }
    for (const Section& section : town.sections)
      EXPECT_NEAR(sum[section.edge], area(section.surface), 1e-9);
  }
}

TEST(SectionTaper, IsNoLongerThanTheStreetLeaves) {
  std::vector<StreetAxis> short_one = widening(fast);
  short_one[1].line = {{0, 0, 0}, {20, 0, 0}};
  const Streets town = streets(short_one, {});
  for (const MultiPolygon& surface : surfaces_of(town))
    for (const Point& p : surface.front().front())
      if (p.x > 0.4 * 20 + 4 && p.y > 0) {
        EXPECT_NEAR(p.y, 6, 1e-9);
      }
}

TEST(SectionTaper, HasNoPartInAFixedLength) {
  StreetSettings fixed;
  fixed.transition.length = 5;
  for (const Roadway& roadway : streets(widening(fast), fixed).roadways)
    EXPECT_TRUE(roadway.profile.empty());
}

// A wide street and a narrow one come to a wide one by small angles. The kerb of the narrow one
// tapers, but the wide street goes on beside it and keeps its kerb.
TEST(SectionTaper, StaysOutOfTheKerbOfAStreetThatGoesOnBesideTheNarrowOne) {
  for (const bool mirrored : {false, true}) {
    const double y = mirrored ? 3 : -3;
    const Streets town = streets(
        {axis(1, {{-100, -y, 0}, {0, 0, 0}}, 10.5, 30), axis(2, {{0, 0, 0}, {100, 0, 0}}, 10.5, 30),
         axis(3, {{-100, y, 0}, {0, 0, 0}}, 3.5, 30)},
        {});
    for (const SectionLimit& limit : town.limits)
      if (limit.edge == 1)
        EXPECT_NEAR(distance(limit.border_line[0], limit.border_line[1]), 10.5, 1e-9);
  }
}

// A street of 6 m is 1.5 m wider on both sides than the street about it. On either side the arc of
// a side street has its kerb all along: the taper begins behind it.
TEST(SectionTaper, BeginsBehindAnArcAtTheOtherEnd) {
  const Streets town =
      streets({axis(1, {{-100, 0, 0}, {0, 0, 0}}, 8, 30), axis(2, {{0, 0, 0}, {6, 0, 0}}, 11, 30),
               axis(3, {{6, 0, 0}, {100, 0, 0}}, 8, 30), axis(4, {{0, 0, 0}, {0, 60, 0}}, 6, 30),
               axis(5, {{6, 0, 0}, {6, -60, 0}}, 6, 30)},
              {});
  Geos geos;
  const MultiPolygon ground = geos.polygons(geos.unite(surfaces_of(town)).get());
  EXPECT_NEAR(area(ground), ground_of(town), 1e-9);
  int on_stub = 0;
  for (const Corner& corner : town.corners) {
    if (!corner.arc) continue;
    for (const Point& end : {corner.arc->start, corner.arc->end}) {
      if (std::abs(std::abs(end.y) - 5.5) > 1e-6) continue;
      ++on_stub;
      EXPECT_TRUE(PreparedSurface(ground).holds({end.x, end.y * 0.995, 0})) << end.x;
      EXPECT_FALSE(PreparedSurface(ground).holds({end.x, end.y * 1.005, 0})) << end.x;
    }
  }
  EXPECT_EQ(on_stub, 2);
}

}  // namespace section_taper_test
}  // namespace streetgen
