#include "geometry/surface_distance.hpp"

#include <gtest/gtest.h>

namespace streetgen {
namespace surface_distance_test {

MultiPolygon box(double x, double y, double size) {
  return {{{{x, y, 0}, {x + size, y, 0}, {x + size, y + size, 0}, {x, y + size, 0}, {x, y, 0}}}};
}

struct Case {
  const char* what;
  MultiPolygon a, b;
  bool near;
};

TEST(Near, AsTheirNearestPlacesTell) {
  const MultiPolygon cross = {
      {{{40, -50, 0}, {60, -50, 0}, {60, 150, 0}, {40, 150, 0}, {40, -50, 0}}}};
  const MultiPolygon ring = {
      {box(0, 0, 100)[0][0], {{10, 10, 0}, {10, 90, 0}, {90, 90, 0}, {90, 10, 0}, {10, 10, 0}}}};
  for (const Case& c : {Case{"side by side", box(0, 0, 10), box(10.9, 0, 10), true},
                        Case{"apart", box(0, 0, 10), box(11.1, 0, 10), false},
                        Case{"a corner off a side",
                             box(0, 0, 10),
                             {{{{10.9, 5, 0}, {20, 0, 0}, {20, 10, 0}, {10.9, 5, 0}}}},
                             true},
                        Case{"corner by corner", box(0, 0, 10), box(10.8, 10.8, 10), false},
                        Case{"touching", box(0, 0, 10), box(10, 0, 10), true},
                        Case{"over each other", box(0, 0, 100), cross, true},
                        Case{"one in the other", box(0, 0, 100), box(40, 40, 20), true},
                        Case{"in a hole", ring, box(40, 40, 20), false},
                        Case{"in a hole, by its side", ring, box(10.5, 40, 20), true},
                        Case{"nothing", box(0, 0, 10), {}, false}}) {
    EXPECT_EQ(come_near(c.a, c.b, 1), c.near) << c.what;
    EXPECT_EQ(come_near(c.b, c.a, 1), c.near) << c.what << ", the other way round";
  }
}

}  // namespace surface_distance_test
}  // namespace streetgen
