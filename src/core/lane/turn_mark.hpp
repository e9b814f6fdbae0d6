// The turns that marks on lanes mean.
#pragma once

#include <cmath>

#include "streetgen/lane.hpp"

namespace streetgen {

struct MarkedTurn {
  unsigned bit;
  double angle;  // degrees to the left
};
constexpr MarkedTurn marked_turns[] = {
    {turn::sharp_left, 135},   {turn::left, 90},   {turn::slight_left, 35},
    {turn::merge_left, 0},     {turn::through, 0}, {turn::merge_right, 0},
    {turn::slight_right, -35}, {turn::right, -90}, {turn::sharp_right, -135},
};

// Whether a way at a node, by its angle, may be what a mark means: turns differ more than ways
// straight on do.
inline bool answers(double way, double marked) {
  return std::abs(way - marked) <= (std::abs(marked) > 45 ? 75 : 50);
}

}  // namespace streetgen
