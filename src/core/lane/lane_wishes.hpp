// The lanes that each edge wants, with what was decided about them.
#pragma once

#include <vector>

#include "roundabout/circulation.hpp"
#include "streetgen/lane.hpp"

namespace streetgen {

class LaneWishes {
 public:
  LaneWishes(std::vector<LanesOfAxis> axes, std::vector<LaneOverride> overrides,
             const std::vector<Circulation>& circulations, const LaneSettings& settings);

  struct Decision {
    bool by_hand = false;
    const Line* line = nullptr;  // null: it follows the axis
  };
  struct OfEdge {
    std::vector<LaneWish> lanes;      // from the left kerb to the right one
    std::vector<Decision> decisions;  // of each lane
  };
  // The wishes of the source for the axis, then of roundabouts, then of overrides.
  OfEdge of(const Edge& edge) const;

  // Whether traffic goes round a roundabout on the edge.
  bool circulates(const Edge& edge) const { return circulations_.of(edge) != nullptr; }
  // The same, or its source says so.
  bool on_ring(const Edge& edge) const;
  // Whether the source marks turns on lanes of any axis.
  bool mark_any() const;

 private:
  const LanesOfAxis* axis_of(const Edge& edge) const;
  void decide(const Edge& edge, OfEdge& found) const;

  std::vector<LanesOfAxis> axes_;
  std::vector<LaneOverride> overrides_;
  Circulations circulations_;
  LaneSettings settings_;
};

}  // namespace streetgen
