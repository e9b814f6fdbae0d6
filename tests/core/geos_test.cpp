#include "../../src/core/geos.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "../../src/core/overlap.hpp"
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

// Rectangles that nearly coincide, far from the origin.
TEST(Geos, MakesFacesOfWhatNearlyCoincides) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
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
    std::vector<MultiPolygon> all;
    std::vector<Line> lines;
    for (int i = 0; i < 6; ++i) {
      const double width = 1 + 4 * share(), length = 10 + 10 * share();
      const double y = 3 * share(), x = 3 * share();
      const double by = random() % 3 ? 1e-6 * share() : share();
      all.push_back(rectangle(turn + by, x, y, length, width));
      lines.push_back(all.back().front().front());
    }
    const MultiPolygon faces = geos.faces(lines);
    for (const MultiPolygon& rectangle : all) {
      MultiPolygon held;
      for (const Polygon& face : faces)
        if (inside(geos.place_inside(face), rectangle.front())) held.push_back(face);
      const MultiPolygon joined = geos.joined(held);
      EXPECT_TRUE(geos.valid(geos.surface(joined).get())) << seed;
      EXPECT_NEAR(area(joined), area(rectangle), 1e-5) << seed;
    }
  }
}

}  // namespace
}  // namespace streetgen
