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

// The border of two streets 6 m wide on two levels; the first comes before.
std::vector<Line> border_between(const Line& a, const Line& b) {
  const MultiPolygon ground_a = section_surface(a, 6, 0, length(a)),
                     ground_b = section_surface(b, 6, 0, length(b));
  Claim claim_a, claim_b;
  claim_a.skeleton.push_back({&a, 0, length(a)});
  claim_b.skeleton.push_back({&b, 0, length(b)});
  claim_a.width = claim_b.width = 6;
  claim_b.axis_id = claim_b.level = 1;
  const PreparedSurface surface_a(ground_a), surface_b(ground_b);
  return Dispute({&claim_a, &surface_a}, {&claim_b, &surface_b}).border();
}

// Places about every metre lie half a metre apart from those of the other axis.
TEST(Dispute, OfAxesOneBesideTheOtherHasNoTeeth) {
  const Line axis{{0, 0, 0}, {60, 0, 0}};
  for (const double apart : {0.0, 0.001, 0.1, 0.4, 0.9})
    for (const Line& part : border_between(axis, {{-0.5, apart, 0}, {60.5, apart, 0}}))
      for (const Point& p : part) EXPECT_TRUE(p.x < 3 || p.x > 57) << apart << ' ' << p.x;
  double size = 0;
  for (const Line& part : border_between(axis, {{-0.5, 1.1, 0}, {60.5, 1.1, 0}}))
    size += length(part);
  EXPECT_NEAR(size, 60, 6);
}

// From where they are a metre apart on in the middle, and straight across before.
TEST(Dispute, OfAxesThatPartSlowlyEndsWhereTheyRunOneBesideTheOther) {
  const Point along = unit(Point{100, 4, 0});
  double across = 0;
  for (const Line& part : border_between({{0, 0, 0}, {60, 0, 0}}, {{0.4, 0.016, 0}, along * 60.4}))
    for (std::size_t i = 1; i < part.size(); ++i) {
      const Point middle = (part[i - 1] + part[i]) * 0.5;
      if (middle.x < 2 || middle.x > 58) continue;
      EXPECT_GT(middle.x, 22);
      if (middle.x > 26)
        EXPECT_NEAR(middle.y, middle.x * 0.02, 0.15) << "x " << middle.x;
      else
        across += std::abs(part[i].y - part[i - 1].y);
    }
  EXPECT_NEAR(across, 2.5, 0.5);
}

}  // namespace dispute_test
}  // namespace streetgen
