// Footways that a source maps apart from the streets: which side of which street each of them is
// the sidewalk of.
//
// A footway is the sidewalk of a side where it runs along it, within `direction` of it, no farther
// from its kerb than `distance`. Sides and footways are compared by pairs: what another street does
// changes nothing.
#pragma once

#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

// One side of an edge.
struct StreetSide {
  int edge = 0;  // index of its line
  bool left = true;
  // Metres from the line of the edge to the kerb, where the line starts and ends.
  double kerb_at_start = 0;
  double kerb_at_end = 0;
};

// The line of an edge or of a footway.
struct LevelLine {
  Line line;
  int level = 0;
};

// The place of a side beside which a place of a footway lies.
struct SidePlace {
  double abscissa = 0;  // metres along the edge
  double distance = 0;  // metres from the kerb to the footway; less than 0: in the roadway
};

// A stretch of a side along which a footway runs.
struct SidewalkSource {
  int side = 0;     // index
  int footway = 0;  // index
  // Metres along the edge.
  double start = 0;
  double end = 0;
  // Metres from the kerb to the footway, the median; less than 0: in the roadway.
  double distance = 0;
  // Places from start to end between which the footway runs straight, within `straight` of the
  // match; none where it keeps its distance all along.
  std::vector<SidePlace> course;
};

struct FootwayMatch {
  double distance = 12;  // metres from a kerb to its farthest footway
  // Metres that a footway may lie within the kerb, whose place is a guess; half of the way to the
  // axis at most.
  double in_roadway = 2;
  double direction = 0.5;  // radians between a footway and the edge, at most
  double straight = 0.5;   // metres that a footway may lie off its course
};

// The stretches of all sides, by side, footway and start. Pieces of one footway along one side that
// are less than 6 m apart are one stretch. A footway without length has none.
std::vector<SidewalkSource> sidewalk_sources(const std::vector<LevelLine>& edges,
                                             const std::vector<StreetSide>& sides,
                                             const std::vector<LevelLine>& footways,
                                             const FootwayMatch& match);

}  // namespace streetgen
