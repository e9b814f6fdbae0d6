// Where lanes come to roundabouts, and wait.
#pragma once

#include <optional>
#include <vector>

#include "lane/lane_layout.hpp"
#include "lane/lane_wishes.hpp"
#include "streetgen/street.hpp"

namespace streetgen {

class RingEntries {
 public:
  RingEntries(const Streets& streets, const LaneWishes& wishes);

  bool on_ring(int edge) const { return on_ring_[edge]; }
  // Whether traffic that leaves the edge at that end comes to a ring.
  bool enters(int edge, bool at_start) const;

  // Across a lane, nearest to the ring but beside its roadway.
  struct Place {
    Point middle;
    Point rightwards;  // unit, seen along the axis
  };
  // None where the section reaches as far, or limits crossed and the edge ends before it.
  std::optional<Place> before_ring(const LaneStrip& strip, const Lane& lane, bool at_start,
                                   bool limits_crossed) const;

 private:
  int node_of(int edge, bool at_start) const;
  bool on_roadway(const Point& place, int node) const;

  const Streets& streets_;
  std::vector<bool> on_ring_;            // by edge
  std::vector<std::vector<int>> rings_;  // by node: the edges on rings there
};

}  // namespace streetgen
