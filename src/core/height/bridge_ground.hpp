// Bridges and tunnels without heights of their own lead from end to end.
#pragma once

#include <vector>

#include "height/height_line.hpp"
#include "streetgen/profile.hpp"

namespace streetgen {

// A part of a road that is to be clear of the ground.
struct ClearStretch {
  int edge = 0;
  bool sinks = false;  // clear below the ground, else above it
  HeightLine bound;    // at least so high, or at most
  bool falls_from = true,
       falls_to = true;  // does the road come back to the ground beyond that end?
};

struct BridgeGround {
  std::vector<HeightLine> ground;  // of each edge: bridges lead evenly from end to end
  std::vector<ClearStretch> clear;
};

BridgeGround ground_with_bridges(const std::vector<ProfileEdge>& edges,
                                 const std::vector<ProfileLift>& lifts, double level_length);

}  // namespace streetgen
