// Places of lanes through the lines of their edges: neighbours and heights.
#pragma once

#include <unordered_map>
#include <vector>

#include "streetgen/lane_measures.hpp"
#include "streetgen/traffic_network.hpp"

namespace streetgen {

// Where a lane is along its edge.
class LanePlaces {
 public:
  LanePlaces(const TrafficEdge& edge, const TrafficLink& lane);

  // Metres in the direction of the traffic, of a place of the edge.
  double on_link(double abscissa) const;
  // Places of the edge between which shares are equal.
  const std::vector<double>& breaks() const { return measures_.on_axis; }

 private:
  LaneMeasures measures_;
  bool along_ = true;
  double length_ = 0;
};

// The stretches of a link beside another one, in the order of the traffic.
std::vector<LinkBeside> stretches_beside(const TrafficBeside& beside, const LanePlaces& lane,
                                         const LanePlaces& other, int other_link);

// Heights along a lane, from the line of its edge.
std::vector<LinkHeight> lane_heights(const TrafficEdge& edge, const TrafficLink& lane,
                                     const LanePlaces& places);

}  // namespace streetgen
