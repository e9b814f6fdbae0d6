// Lanes that begin or end where a street goes on with another width past a side street.
#pragma once

#include <vector>

#include "lane/lane_layout.hpp"
#include "streetgen/lane.hpp"

namespace streetgen {

// The lanes that change at an end of an edge, by index from the left kerb in its direction.
struct ChangingLanes {
  std::vector<int> ending;  // they end or begin at the node: they take what the taper takes away
  std::vector<int> beside;  // lanes of the other edge begin beside them: they take what it adds
};
struct TaperedLanes {
  ChangingLanes start, end;
};

// The lanes of an edge, from the left kerb in its direction, with the end that touches the node.
struct LanesAtNode {
  const std::vector<LaneWish>& lanes;
  bool at_start = true;
};

// Finds those lanes of `here`, beyond which the street goes on as `there`. Lanes are counted by
// direction and by kind, lanes of motor traffic together. Of lanes too many those change that are
// marked for a turn or a merge alone, on their side; beyond these the outer ones.
ChangingLanes changing_lanes(const LanesAtNode& here, const LanesAtNode& there, DrivingSide side);

// The lines between lanes, kerbs included. What a kerb departs from the edge's own width goes to
// the lanes that change on its side of the middle, or where one side has none to all that change;
// without any, all lanes share it. Ground beside the lanes takes it before them. `own` are the
// shares of the lanes of the edge's own width. Merging lanes come first and last, those of the left
// kerb and those of the right one in the order of strip.merging.
std::vector<LaneShares> tapered_shares(const LaneStrip& strip, const std::vector<double>& own,
                                       const TaperedLanes& tapered);

}  // namespace streetgen
