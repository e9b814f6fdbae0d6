#include "ownership/notch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/polyline.hpp"

namespace streetgen {
namespace notch_test {

// A ring of short chords whose radius swings, so that its border bends back within a metre.
Ring swinging(const Point& centre, double radius, double swing, int waves, double turn) {
  constexpr int chords = 60;
  Ring ring;
  for (int i = 0; i <= chords; ++i) {
    const double angle = 2 * M_PI * (i % chords) / chords + turn;
    const double at = radius * (1 + swing * std::sin(waves * angle));
    ring.push_back({centre.x + at * std::cos(angle), centre.y + at * std::sin(angle), 0});
  }
  return ring;
}

// A notch ends 1.5 m from the place where borders cross, whatever way the borders take.
TEST(Notch, LiesBesideThePlaceWhereBordersCross) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0, 1);
  int notches = 0;
  for (int round = 0; round < 4000; ++round) {
    const double radius = 0.2 + 2 * share(random), other = 0.2 + 2 * share(random);
    const double apart = (radius + other) * (0.3 + share(random));
    const int waves = 1 + round % 5;
    const MultiPolygon a{{swinging({0, 0, 0}, radius, 0.8 * share(random), waves, share(random))}},
        b{{swinging({apart, 0, 0}, other, 0.8 * share(random), waves, 6 * share(random))}};
    for (const Line& line :
         across_notches(a, b, 3 * share(random), [](const Point&) { return true; })) {
      ++notches;
      double farthest = 0;
      for (const Point& p : line) farthest = std::max(farthest, distance(p, line.front()));
      EXPECT_LT(farthest, 2 * 1.5 + 0.1) << round;
    }
  }
  EXPECT_GT(notches, 1000);
}

}  // namespace notch_test
}  // namespace streetgen
