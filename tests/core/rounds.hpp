// How often a random test tries: whole in an ordinary run, in part where each try is slow.
#pragma once

#include <algorithm>
#include <cstdlib>

namespace streetgen {

/// The part of `whole` tries that STREETGEN_ROUNDS (more than 0, at most 1; 1 where it is not set) asks for, at least one.
inline int rounds(int whole) {
  const char* part = std::getenv("STREETGEN_ROUNDS");
  return std::max(1, static_cast<int>(whole * (part ? std::atof(part) : 1)));
}

}
