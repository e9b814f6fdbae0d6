// The strip behind one kerb, before others take part of it.
#pragma once

#include "sidewalk/kerb_chain.hpp"

namespace streetgen {

struct Strip {
  MultiPolygon surface;
  double widest = 0;  // metres
  bool plain = true;  // one ring along the kerb, which it cannot cross
};

// Empty where the kerb has no sidewalk. Kerbs that follow each other share the side between their
// strips: the bisector of an inner bend; about an outer one the later kerb goes round.
Strip strip_behind(const std::vector<SidewalkKerb>& kerbs, const KerbChains& chains, int kerb);

}  // namespace streetgen
