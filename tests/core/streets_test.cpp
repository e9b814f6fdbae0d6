#include "streetgen/streets.hpp"

#include <gtest/gtest.h>

#include <random>

#include "../../src/core/geos.hpp"
#include "../../src/core/overlap.hpp"
#include "../../src/core/polyline.hpp"

namespace streetgen {
namespace {

std::vector<StreetAxis> random_town(unsigned seed, int count) {
  std::mt19937_64 random(seed);
  std::vector<Point> places;
  for (int i = 0; i < count / 2; ++i)
    places.push_back({650000 + random() % 4000 / 10.0, 6860000 + random() % 4000 / 10.0, 0});
  std::vector<StreetAxis> axes;
  for (int i = 0; i < count; ++i) {
    const Point &a = places[random() % places.size()], &b = places[random() % places.size()];
    if (distance(a, b) < 1) continue;
    StreetAxis axis;
    axis.axis_id = i + 1;
    axis.line = {a, b};
    axis.width = axis.width_end = 3 + random() % 120 / 10.0;
    axis.radius = random() % 80 / 10.0;
    axis.importance = 1 + random() % 5;
    axes.push_back(axis);
  }
  return axes;
}

// Towns far worse than real ones: streets at any angle, wide, crossing, overlapping.
TEST(Streets, SurfacesAreValidAndTileWhateverTheTown) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    StreetSettings settings;
    settings.crossing = Crossing::split;
    const Streets town = streets(random_town(seed, 40), settings);
    Geos geos;
    std::vector<const MultiPolygon*> surfaces;
    double roadway = 0, shared = 0;
    for (const Section& section : town.sections) surfaces.push_back(&section.surface);
    for (const Intersection& intersection : town.intersections)
      surfaces.push_back(&intersection.surface);
    for (const MultiPolygon* surface : surfaces) {
      EXPECT_TRUE(geos.valid(geos.surface(*surface).get())) << "seed " << seed;
      roadway += area(*surface);
    }
    for (std::size_t i = 0; i < surfaces.size(); ++i)
      for (std::size_t j = i + 1; j < surfaces.size(); ++j)
        if (overlap(*surfaces[i], *surfaces[j]))
          shared += area(geos.polygons(
              geos.intersection(geos.surface(*surfaces[i]).get(), geos.surface(*surfaces[j]).get())
                  .get()));
    EXPECT_LE(shared, 1e-4 * roadway) << "seed " << seed;
  }
}

TEST(Streets, LimitsAreInOrderAndTwoPerEdge) {
  const Streets town = streets(random_town(21, 60), {});
  ASSERT_EQ(town.limits.size(), 2 * town.network.edges.size());
  for (std::size_t e = 0; e < town.network.edges.size(); ++e)
    EXPECT_LE(town.limits[2 * e].abscissa, town.limits[2 * e + 1].abscissa + 1e-9);
}

TEST(Streets, DoesNotDependOnTheOrderOfTheAxes) {
  std::vector<StreetAxis> axes = random_town(5, 50);
  const Streets first = streets(axes, {});
  std::reverse(axes.begin(), axes.end());
  const Streets second = streets(axes, {});
  ASSERT_EQ(first.sections.size(), second.sections.size());
  for (std::size_t i = 0; i < first.sections.size(); ++i)
    EXPECT_EQ(area(first.sections[i].surface), area(second.sections[i].surface));
}

}  // namespace
}  // namespace streetgen
