// Kerbs put together to rings of the ground.
#pragma once

#include <vector>

#include "geometry/box.hpp"
#include "streetgen/geometry.hpp"
#include "streetgen/kerb.hpp"

namespace streetgen {

struct KerbLoop {
  // With the ground on its left: counter-clockwise about ground, clockwise about roadway.  It
  // begins at its least vertex, so that it is the same whichever kerb comes first.
  Ring ring;
  Box box;
  std::vector<int> kerbs;  // index into the kerbs given
};

struct KerbLoops {
  std::vector<KerbLoop> loops;
  std::vector<int> loose;  // kerbs of no loop: the next one is missing
};

// Each kerb goes on with the one that begins where it ends. Where several do, in a place where
// roadways touch, it turns left as sharply as it can, so that no loop crosses another.
KerbLoops kerb_loops(const std::vector<Kerb>& kerbs);

}  // namespace streetgen
