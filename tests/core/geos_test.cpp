#include "../../src/core/geos.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "../../src/core/polyline.hpp"

namespace streetgen {
namespace {

const Ring square{{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}};
const Ring hole{{1, 1}, {1, 2}, {2, 2}, {1, 1}};
const Ring open{{3, 3}, {3, 4}, {4, 4}, {4, 3}};

// The leak checker of the sanitized build fails it where a part made before is lost.
TEST(Geos, KeepsNothingOfASurfaceThatFailsHalfWay) {
  Geos geos;
  EXPECT_THROW(geos.polygon({square, hole, open}), std::runtime_error);
  EXPECT_THROW(geos.surface({{square, hole}, {open}}), std::runtime_error);
}

// Rectangles that nearly coincide, far from the origin, taken off and put together again: on one of
// these seeds GEOS 3.11 fails on the grid of a micrometre.
TEST(Geos, TakesOffOnTheGridWhatNearlyCoincides) {
  for (unsigned seed = 19440; seed < 19470; ++seed) {
    std::mt19937_64 random(seed);
    const auto share = [&] { return (random() % 1000001) / 1e6; };
    const auto rectangle = [](double turn, double x, double y, double length, double width) {
      const Point along{std::cos(turn), std::sin(turn), 0}, across = left_normal(along);
      const Point corner{653000 + x, 6861000 + y, 0};
      return MultiPolygon{
          {{corner, corner + along * length, corner + along * length + across * width,
            corner + across * width, corner}}};
    };
    Geos geos;
    const double turn = 7 * share();
    MultiPolygon all = rectangle(turn, 0, 0, 20, 5);
    for (int i = 0; i < 8 && !all.empty(); ++i) {
      const double width = 1 + 4 * share(), length = 10 + 10 * share();
      const double y = 3 * share(), x = 3 * share();
      const double by = random() % 3 ? 1e-6 * share() : share();
      const MultiPolygon other = rectangle(turn + by, x, y, length, width);
      const Geos::Geometry a = geos.surface(all), b = geos.surface(other);
      if (random() % 2) {
        all = geos.polygons(geos.difference_on_grid(a.get(), b.get()).get());
      } else {
        const MultiPolygon rest = geos.polygons(geos.difference_on_grid(b.get(), a.get()).get());
        const MultiPolygon shared = geos.polygons(geos.intersection(b.get(), a.get()).get());
        all = geos.polygons(geos.unite({all, rest, shared}).get());
      }
      EXPECT_TRUE(geos.valid(geos.surface(all).get())) << seed;
    }
  }
}

}  // namespace
}  // namespace streetgen
