// Chains of arcs as functions of the length and the curvature of each, with slopes by these.
#pragma once

#include <cstddef>
#include <vector>

#include "streetgen/plan_view.hpp"

namespace streetgen {

// A fit has no more.
constexpr int most_arcs = 12;

struct ChainArc {
  double length = 0;     // metres
  double curvature = 0;  // one by metres, positive to the left; 0: a line
};

class ArcChain {
 public:
  ArcChain(const ChainPlace& start, std::vector<ChainArc> arcs);

  struct Place {
    double s = 0;  // metres along the chain
    std::size_t arc = 0;
    Point point, way;  // a unit way
  };
  Place at(double s) const;

  // The end of the chain as a place behind its last arc.
  Place end() const;
  double heading_at_end() const { return starts_.back().heading; }

  // The moves of a place by the length and the curvature of each arc in turn.  An arc moves what
  // lies behind it, and by its curvature also what lies in it.
  void slopes(const Place& place, std::vector<Point>& out) const;

  const std::vector<ChainArc>& arcs() const { return arcs_; }
  double length() const { return starts_.back().s; }
  std::vector<PlanPiece> pieces() const;

 private:
  struct Start {
    double s = 0, heading = 0;
    Point point, way;
  };
  std::vector<ChainArc> arcs_;
  std::vector<Start> starts_;  // of each arc, and the end of the last one
};

}  // namespace streetgen
