// Chains held against what a chain is, and against the line that they follow.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "geometry/polyline.hpp"
#include "streetgen/plan_view.hpp"

namespace streetgen {

inline double turn_between(double a, double b) { return std::abs(std::remainder(a - b, 2 * M_PI)); }

// Sixteen of each piece, and the end.
inline Line places(const std::vector<PlanPiece>& chain) {
  Line out;
  for (const PlanPiece& piece : chain)
    for (int i = 0; i < 16; ++i)
      out.push_back(place_at(chain, piece.s + piece.length * i / 16).point);
  out.push_back(place_at(chain, length(chain)).point);
  return out;
}

// Each piece begins where the one before it ends, in place and heading.
inline void expect_smooth(const std::vector<PlanPiece>& chain) {
  for (std::size_t i = 0; i < chain.size(); ++i) {
    ASSERT_GT(chain[i].length, 0);
    if (i == 0) continue;
    ASSERT_NEAR(chain[i].s, chain[i - 1].s + chain[i - 1].length, 1e-9);
    const ChainPlace before = place_at({chain[i - 1]}, chain[i].s);
    ASSERT_LT(distance(before.point, chain[i].start.point), 1e-6);
    ASSERT_LT(turn_between(before.heading, chain[i].start.heading), 1e-6);
  }
}

inline void expect_within(const std::vector<PlanPiece>& chain, const Line& line, double tolerance) {
  const Line drawn = places(chain);
  for (const Point& p : drawn) ASSERT_LE(distance_to_line(p, line), tolerance + 1e-6);
  // A chord of the sixteen leaves its arc by less than the tenth part.
  for (const Point& p : line) ASSERT_LE(distance_to_line(p, drawn), 1.1 * tolerance);
}

}  // namespace streetgen
