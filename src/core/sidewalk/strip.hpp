// The strips behind kerbs, before others take part of them.
#pragma once

#include <vector>

#include "sidewalk/kerb_chain.hpp"

namespace streetgen {

struct Strip {
  MultiPolygon surface;  // empty where the kerb has no sidewalk
  double width = 0;      // metres: as wanted, of one that changes the mean
  double widest = 0;     // metres
  double reach = 0;      // metres: no part of it is farther from its kerb
  bool plain = true;     // one ring along the kerb, which it cannot cross
  bool narrow = false;   // another kerb of its chain, across, has part of what it wants
};

// One for each kerb. Kerbs that follow each other part their ground by pass_front; where that
// cannot tell, all within the width of the sidewalk is the strip of a kerb.
std::vector<Strip> strips_behind(const std::vector<SidewalkKerb>& kerbs, const KerbChains& chains);

}  // namespace streetgen
