// Kinds of ground beside a kerb.
#pragma once

#include <vector>

namespace streetgen {

enum class Beside {
  outer,     // a block of the city, or open ground
  median,    // between the two carriageways of one street
  splitter,  // between arms of one junction
  island,    // of a roundabout, or of a slip lane
};
const char* beside_name(Beside beside) noexcept;

// By slot, that is 2 * edge for the start of an edge and 2 * edge + 1 for its end.
struct BesideEdges {
  // The ground on the left, seen from that end: of 2 * edge on the edge's left side.
  std::vector<Beside> sides;
  std::vector<Beside> corners;  // the ground counter-clockwise from that end
  // The stretches of that side along which a median lies: from, to, from, to …, ascending, in
  // metres along the edge. Empty where the side is of one kind all along.
  std::vector<std::vector<double>> medians;
};

}  // namespace streetgen
