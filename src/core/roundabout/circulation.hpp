// Traffic that goes round roundabouts, edge by edge.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "streetgen/lane.hpp"

namespace streetgen {

class Circulations {
 public:
  explicit Circulations(const std::vector<Circulation>& all);
  // Null: traffic on the edge goes as its axis says.
  const Circulation* of(const Edge& edge) const;

 private:
  std::multimap<std::int64_t, Circulation> by_axis_;
};

// All lanes of an edge that is turned go round; what was painted for another direction goes.
void turn_round(const Circulation& circulation, std::vector<LaneWish>& wishes);

}  // namespace streetgen
