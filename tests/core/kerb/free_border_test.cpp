#include "kerb/free_border.hpp"

#include <gtest/gtest.h>

#include "geometry/polyline.hpp"

namespace streetgen {
namespace {

double unshared(double crack) {
  const MultiPolygon lower = {{{{0, -5}, {0, 0}, {6, 0}, {6, -5}, {0, -5}}}};
  const MultiPolygon upper = {{{{0, crack}, {0, 5}, {6, 5}, {6, 0}, {0, crack}}}};
  FreeBorder border(lower);
  border.share_with(upper, false);
  double sum = 0;
  for (const BorderLoop& loop : border.loops())
    for (const BorderPiece& piece : loop)
      if (!piece.shared) sum += distance(piece.from, piece.to);
  return sum;
}

// Two sections of a straight street once met in a crack of 1.27 micrometres: each had half of the
// street's width as a kerb there, and a sidewalk on the roadway of the other.
TEST(FreeBorder, GoesOverACrackThatIsNoGround) {
  EXPECT_NEAR(unshared(0), 16, 1e-9);
  EXPECT_NEAR(unshared(1.27e-6), 16, 1e-5);
  EXPECT_NEAR(unshared(9e-6), 16, 1e-5);
  EXPECT_NEAR(unshared(1e-3), 22, 1e-3);
}

}  // namespace
}  // namespace streetgen
