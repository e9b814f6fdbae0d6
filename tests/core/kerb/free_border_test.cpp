#include "kerb/free_border.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/polyline.hpp"

namespace streetgen {
namespace free_border_test {

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

// Where the last unshared piece of a border ends that comes from `from`.
Point mouth(const MultiPolygon& surface, const MultiPolygon& neighbour) {
  FreeBorder border(surface);
  border.share_with(neighbour, false);
  const std::vector<BorderLoop> loops = border.loops();
  const BorderLoop& loop = loops.front();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const BorderPiece& next = loop[(i + 1) % loop.size()];
    if (loop[i].shared == next.shared) continue;
    if (distance(loop[i].to, {0, 0, 0}) < 1e-3) return loop[i].to;
  }
  return {};
}

// The tip of a surface lies 24 micrometres deep in a notch of its neighbour, less than one beside
// the neighbour's free border. Both sides find the mouth of the notch.
TEST(FreeBorder, EndsAtTheMouthOfANeedleOnBothSides) {
  const Point tip{-0.3114e-6, -23.9685e-6, 0}, beside{-0.0623e-6, 3.2126e-6, 0};
  const MultiPolygon notched = {{{{0.672602, -33.18723, 0},
                                  {0, 0, 0},
                                  tip,
                                  beside,
                                  {-10.5, 0.096, 0},
                                  {-10.5, -33, 0},
                                  {0.672602, -33.18723, 0}}}};
  const MultiPolygon pointed = {{{{-10.5, 0.096, 0},
                                  beside,
                                  tip,
                                  {552.5824e-6, 43663.0971e-6, 0},
                                  {-10.5, 0.213, 0},
                                  {-10.5, 0.096, 0}}}};
  EXPECT_LT(distance(mouth(notched, pointed), {0, 0, 0}), 1e-9);
  EXPECT_LT(distance(mouth(pointed, notched), {0, 0, 0}), 1e-9);
}

// A slit that is no ground has no kerb, also where a neighbour shares the rest of its sides.
TEST(FreeBorder, GoesOverASlitInASurfaceBesideANeighbour) {
  const MultiPolygon slit = {
      {{{0, 0, 0}, {10, 0, 0}, {10, 4, 0}, {6e-6, 4, 0}, {6, 2, 0}, {0, 4, 0}, {0, 0, 0}}}};
  const MultiPolygon upper = {
      {{{0, 4, 0}, {0, 9, 0}, {-5, 9, 0}, {-5, 5 + 2.0 / 3, 0}, {0, 4, 0}}}};
  const MultiPolygon wedge = {{{{0, 4, 0}, {3, 3, 0}, {3, 3 + 3e-6, 0}, {0, 4, 0}}}};
  FreeBorder border(slit);
  border.share_with(upper, false);
  border.share_with(wedge, false);
  border.share_with_itself();
  for (const BorderLoop& loop : border.loops())
    for (const BorderPiece& piece : loop)
      if (!piece.shared) {
        const Point middle = (piece.from + piece.to) * 0.5;
        EXPECT_FALSE(middle.x > 0.1 && middle.x < 5.9 && middle.y > 1 && middle.y < 3.9);
      }
}

// A needle of ground along two neighbours has a border on its other side.
TEST(FreeBorder, KeepsTheFarSideOfANeedleOfGround) {
  const MultiPolygon needle = {
      {{{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {14, 3, 0}, {4, 3 + 3e-6, 0}, {0, 3, 0}, {0, 0, 0}}}};
  const MultiPolygon below = {{{{4, 0, 0}, {8, 0, 0}, {8, 3, 0}, {4, 3, 0}, {4, 0, 0}}}};
  const MultiPolygon beyond = {{{{8, 0, 0}, {14, 0, 0}, {14, 3, 0}, {8, 3, 0}, {8, 0, 0}}}};
  FreeBorder border(needle);
  border.share_with(below, false);
  border.share_with(beyond, false);
  border.share_with_itself();
  double sum = 0;
  for (const BorderLoop& loop : border.loops())
    for (const BorderPiece& piece : loop)
      if (!piece.shared) sum += distance(piece.from, piece.to);
  EXPECT_NEAR(sum, 4 + 3 + 4 + 10, 1e-4);
}

// A hole a tenth of a micrometre wide lies against the border, beyond which a neighbour goes on.
TEST(FreeBorder, GoesOverAHoleThatIsNoGroundAtABorder) {
  const MultiPolygon holed = {
      {{{0, -5, 0}, {0, 0, 0}, {2, 0, 0}, {3, 6e-8, 0}, {6, 0, 0}, {6, -5, 0}, {0, -5, 0}},
       {{2, 0, 0}, {2, -6e-8, 0}, {3, 0, 0}, {2, 0, 0}}}};
  const MultiPolygon upper = {
      {{{0, 0, 0}, {0, 5, 0}, {6, 5, 0}, {6, 0, 0}, {3, 6e-8, 0}, {0, 0, 0}}}};
  FreeBorder border(holed);
  border.share_with(upper, false);
  border.share_with_itself();
  for (const BorderLoop& loop : border.loops())
    for (const BorderPiece& piece : loop)
      EXPECT_TRUE(piece.shared || std::min(piece.from.y, piece.to.y) < -1);
}

// The vertices of an intersection of Sophia Antipolis: its ring goes back by four micrometres.
TEST(FreeBorder, IsOnePieceWhereItsRingGoesToAndFro) {
  const MultiPolygon folded = {{{{10.5731586, -1.5591624, 0},
                                 {3.4210810, -0.5044922, 0},
                                 {3.4210854, -0.5044928, 0},
                                 {0, 0, 0},
                                 {-0.6, -20, 0},
                                 {11, -20, 0},
                                 {10.5731586, -1.5591624, 0}}}};
  FreeBorder border(folded);
  border.share_with_itself();
  const std::vector<BorderLoop> loops = border.loops();
  ASSERT_EQ(loops.size(), 1u);
  for (std::size_t i = 0; i < loops[0].size(); ++i) {
    EXPECT_FALSE(loops[0][i].shared);
    EXPECT_LT(distance(loops[0][i].to, loops[0][(i + 1) % loops[0].size()].from), 1e-7);
  }
}

// The ring of an intersection goes back by 19 micrometres and on again.
TEST(FreeBorder, LeavesNoGapWhereItsRingGoesToAndFro) {
  const MultiPolygon folded = {{{{17.9084782, -1.4043094, 0},
                                 {0, 0, 0},
                                 {0.0000190, -0.0000015, 0},
                                 {-17.0543639, 1.3374422, 0},
                                 {-17, -20, 0},
                                 {17, -20, 0},
                                 {17.9084782, -1.4043094, 0}}}};
  FreeBorder border(folded);
  border.share_with_itself();
  const std::vector<BorderLoop> loops = border.loops();
  const Point* before = nullptr;
  double gap = 0, sum = 0;
  for (int round = 0; round < 2; ++round)
    for (const BorderPiece& piece : loops.front()) {
      if (piece.shared) continue;
      if (before != nullptr) gap = std::max(gap, distance(*before, piece.from));
      before = &piece.to;
      if (round == 0) sum += distance(piece.from, piece.to);
    }
  EXPECT_LT(gap, 1e-6);
  EXPECT_NEAR(sum, length(folded[0][0]), 4e-5);
}

}  // namespace free_border_test
}  // namespace streetgen
