#include "geometry/hairline.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/polyline.hpp"

namespace streetgen {
namespace hairline_test {

// Wherever the ring begins.
void expect_ring(const Ring& ring, std::size_t corners, double area) {
  Ring open(ring.begin(), ring.end() - 1);
  for (std::size_t begin = 0; begin < open.size(); ++begin) {
    Ring turned = open;
    std::rotate(turned.begin(), turned.begin() + begin, turned.end());
    turned.push_back(turned.front());
    const Ring left = without_hairlines(turned);
    EXPECT_EQ(left.size(), corners == 0 ? 0 : corners + 1) << begin;
    if (corners > 0) EXPECT_NEAR(signed_area(left), area, 1e-6) << begin;
  }
}

TEST(Hairline, LeavesARingWithoutOne) {
  expect_ring({{0, 0}, {2, 0}, {2, 1}, {0, 1}, {0, 0}}, 4, 2);
  // A wedge that is a tenth of a millimetre wide has ground.
  expect_ring({{0, 0}, {1, 0}, {9, 0.5}, {1, 1e-4}, {1, 1}, {0, 1}, {0, 0}}, 6, 1 + 4e-4);
}

// As two borders that coincide beyond the corner of a notch.
TEST(Hairline, IsLeftOutAtACorner) {
  expect_ring({{0, 0}, {1, 0}, {9, 0}, {1.2, 2e-8}, {1, 1}, {0, 1}, {0, 0}}, 5, 1.1);
}

TEST(Hairline, IsLeftOutWithAllOfItsVertices) {
  expect_ring({{0, 0}, {1, 0}, {5, 1}, {9, 0}, {5, 1 + 1e-7}, {1, 1e-8}, {1, 1}, {0, 1}, {0, 0}}, 4,
              1);
}

TEST(Hairline, IsNoGroundAlone) { expect_ring({{0, 0}, {5, 0}, {9, 1}, {5, 2e-8}, {0, 0}}, 0, 0); }

}  // namespace hairline_test
}  // namespace streetgen
