// The borders of lanes as lines that never fold, as Lanelet2 has them.
#pragma once

#include <vector>

#include "streetgen/plan_view.hpp"

namespace streetgen {

// The line that borders lie beside: a chain, and values at stations along it, straight between them.
struct BorderCourse {
  std::vector<PlanPiece> chain;
  std::vector<double> stations;  // metres along the chain from 0 to its end, two at least
  // By border, then by station: metres to the left of the chain.
  std::vector<std::vector<double>> borders;
  // Metres along the chain, ascending, and the height there; none: all heights are 0.
  std::vector<double> height_stations, heights;
};

struct BorderEnds {
  Point from, to;
};

// The borders as lines, in the direction of the chain, from the left.  None folds: where a bend is
// tighter than a border is far inside it, the border is cut where it crosses itself, and no side
// leads back along the chain.  Chords leave the border and its heights by `tolerance` metres at
// most.  A border begins and ends at its `ends`, where they are given.
std::vector<Line> border_lines(const BorderCourse& course, const std::vector<BorderEnds>& ends,
                               double tolerance);

}  // namespace streetgen
