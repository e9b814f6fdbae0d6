// The middle line of the highway between two towns, and what lies along it.  Metres from the first
// interchange, where the line leads to the east.
#pragma once

#include <cstddef>
#include <vector>

#include "streetgen/two_towns.hpp"
#include "support/random.hpp"

namespace streetgen {

// A place on the middle line.
struct HighwayStation {
  Point at;
  Point left;                 // where a line one metre to the left of the highway passes, from `at`
  double abscissa = 0;        // metres from the first interchange
  bool carriageways = true;   // a vertex of these
  bool country_roads = true;  // a vertex of the roads along the highway
};

struct Highway {
  double carriageway_width = 0;
  double half = 0;                       // from the middle line to the axis of a carriageway
  double outer = 0;                      // from the middle line to the outer kerb
  std::vector<HighwayStation> stations;  // from west to east
  // Stations where a road crosses, as they follow each other: the interchanges are the first and
  // the last one.
  std::vector<std::size_t> crossings;
};

// Straight through each interchange, as long as its ramps and merging lanes want and its town is
// wide, and bent between them, never sharper than the speed allows.
Highway highway_between(const TwoTownsOptions& options, Random& random);

}  // namespace streetgen
