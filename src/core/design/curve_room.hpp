// The part of a side that the least curve of a turn takes.
#pragma once

#include <vector>

#include "streetgen/road_design.hpp"

namespace streetgen {

// From the vertex to the end of the least curve, by the turn: a table, rounded up.
class CurveRoom {
 public:
  explicit CurveRoom(const DesignRules& rules);
  // Metres; infinite for a turn that no road makes (over 170 degrees).
  double tangent(double turn) const;

 private:
  std::vector<double> tangents_;
};

}  // namespace streetgen
