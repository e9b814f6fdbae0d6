// A street of a virtual city while it is drawn.  Metres from the lower left corner of the extent,
// every point on a whole millimetre.
#pragma once

#include <cstdint>
#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

// A place where streets meet, as one of them has it.
struct CityNode {
  double abscissa = 0;
  Point point;
};

enum class CityEnd { blind_alley, road, border };

struct CityStreet {
  int main = -1;  // the street it starts from; none for the first road
  int level = 0;
  double width = 0;
  std::uint64_t key = 0;          // of its random numbers
  bool to_left = false;           // side of its main road
  Line line;                      // its ends and bends
  std::vector<double> abscissas;  // of the points of `line`
  std::vector<CityNode> nodes;    // by abscissa; its ends among them
  CityEnd end = CityEnd::blind_alley;
  int ends_on = -1;  // the road that it reached

  double length() const { return abscissas.back(); }
};

}  // namespace streetgen
