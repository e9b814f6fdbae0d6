#include "ownership/dispute.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "streetgen/surface.hpp"

namespace streetgen {
namespace dispute_test {

// Whether stretches of two lines cross, of streets 4 m wide.
bool crossed(const Line& a, double to_a, const Line& b, double from_b) {
  const MultiPolygon ground_a = section_surface(a, 4, 0, to_a),
                     ground_b = section_surface(b, 4, from_b, length(b));
  Claim claim_a, claim_b;
  claim_a.skeleton.push_back({&a, 0, to_a});
  claim_b.skeleton.push_back({&b, from_b, length(b)});
  claim_a.width = claim_b.width = 4;
  const PreparedSurface surface_a(ground_a), surface_b(ground_b);
  return Dispute({&claim_a, &surface_a}, {&claim_b, &surface_b}).crossed();
}

// Each end of the one lies on the other but for noise.
TEST(Dispute, StretchesThatOverlapOnOneLineDoNotCross) {
  for (int k = 0; k < 200; ++k) {
    const Point from{342487.7557, 4830989.599, 0};
    const Line line{from, from + Point{20 * std::cos(0.1 * k), 20 * std::sin(0.1 * k), 0}};
    EXPECT_FALSE(crossed(line, 14.7, line, 6.3)) << k;
    EXPECT_FALSE(crossed(line, 14.7, reversed(line), 6.3)) << k;
  }
}

TEST(Dispute, StretchesThatCrossAtASmallAngleDo) {
  const Line line{{0, 0, 0}, {20, 0, 0}};
  EXPECT_TRUE(crossed(line, 20, {{0, 0.001, 0}, {20, -0.001, 0}}, 0));
  EXPECT_TRUE(crossed(line, 20, {{8, 10, 0}, {12, -10, 0}}, 0));
  EXPECT_FALSE(crossed(line, 20, {{8, 10, 0}, {12, 0.001, 0}}, 0));
}

}  // namespace dispute_test
}  // namespace streetgen
