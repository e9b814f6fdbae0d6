// Markings on the lanes, in the manner of French towns: stripes, stop and yield lines,
// arrows.
#pragma once

#include <vector>

#include "lane/arrow_paint.hpp"
#include "lane/end_control.hpp"
#include "lane/lane_layout.hpp"
#include "lane/slip_lane_end.hpp"
#include "lane/waiting_place.hpp"
#include "streetgen/lane.hpp"

namespace streetgen {

// The rank by which traffic waits at a node.
struct NodeRank {
  int degree = 0;
  int importance = 99;    // of the most important edge by which traffic comes
  int lowest = 1;         // of the least important one
  int merging_link = -1;  // a link whose lanes all have lanes of their own behind the node
};
// `comes` by slot: whether traffic comes to the node by that end, and others may wait for it.
std::vector<NodeRank> ranks_of(const Streets& streets, const std::vector<bool>& comes);

// Across each lane that comes to a node of three and more edges: what its control point says, a
// stop line for signals; a stop line where another end of the node has signals.  So too before
// signals in mid-block; not where traffic has waited for signals a queue's length before.  Without
// a control point a yield line where another edge is more important, or goes first among equals
// where important streets meet or streets merge, or a slip lane ends; a stop line where it is so by
// two; no line on a ramp whose lanes go on as merging lanes, nor round a roundabout.  A kind by
// hand goes before signals and classes, and leaves signs: signals, stop lines; stop, one where
// another edge is more important, and on all where none is and no end has a stop sign; priority, a
// yield line there; right_before_left, no line at all.  None on parking and very narrow lanes.  Of
// a lane for both directions, across the half on which one comes.  The line lies as WaitingPlaces
// says; else where the lane ends, or where its section shares ground before that. Only lines of
// roundabouts lie where limits crossed.  `controls` by slot, as end_controls gives them.
void append_end_markings(const Streets& streets, const std::vector<NodeRank>& ranks,
                         const std::vector<EndControl>& controls, const WaitingPlaces& waiting,
                         const SlipLaneEnds& slip_lanes, const LaneStrip& strip,
                         bool limits_crossed, const std::vector<Lane>& lanes,
                         DrivingSide driving_side, std::vector<Marking>& out);

// The turns that a lane is marked for: before its line in `out` and its end, or in the middle of a
// short lane; none where the lane is too short or narrow for an arrow, nor on parking lanes, nor on
// lanes for both directions.  A lane without marks has one before signals alone, where
// point_arrows says whether its arm leads apart.
void append_arrows(ArrowPaint& paint, const Streets& streets, const std::vector<NodeRank>& ranks,
                   const std::vector<EndControl>& controls, const std::vector<Lane>& lanes,
                   std::vector<Marking>& out);

}  // namespace streetgen
