// A network of traffic from the lanes of a model and the paths between them.  Wilkie, Sewall and
// Lin, sections 3.1 and 4.2.
#pragma once

#include <cstdint>
#include <vector>

#include "streetgen/geometry.hpp"
#include "streetgen/interconnection.hpp"
#include "streetgen/traffic.hpp"

namespace streetgen {

struct TrafficEdge {
  Line line;               // with heights where `has_heights`
  bool has_heights = false;
  double widest = 0;       // no lane lies farther from the line, metres
};

// A lane in one direction, or a movement.
struct TrafficLink {
  std::int64_t link_id = 0;
  bool movement = false;
  Line line;         // in the direction of the traffic; a movement may have two equal points
  double width = 0;  // metres
  double speed = 0;  // metres a second
  std::uint8_t traffic = traffic::all;
  std::int64_t from_node = 0, to_node = 0;  // their keys
  std::int64_t junction = 0;                // 0: none
  // Of a lane.
  int edge = -1;                // index into TrafficSource::edges
  bool along = true;            // whether its traffic runs along the line of the edge
  double first = 0, last = 0;   // where the lane begins and ends along that line, metres
  std::int64_t other_way = 0;   // link of its other direction; 0: it has one direction
  double stop = 0;              // where a car waits before the end of the lane, metres before it
  // Of a movement: keys of links.
  std::int64_t lane_in = 0, lane_out = 0;
  Turn turn = Turn::through;
  int rank = 0, importance = 0, precedence = 0;  // as ConflictMovement has them
  std::int64_t controller = 0;                   // 0: no signal
  std::vector<SignalAspect> aspects;
};

// A stretch of an edge on which one may look from a lane to the lane on its left or right.
struct TrafficBeside {
  std::int64_t link = 0, other = 0;
  bool left = false;       // as a driver on `link` sees it
  bool may_change = false;
  bool opposite = false;
  double from = 0, to = 0;  // metres along the line of the edge, ascending
};

struct TrafficSource {
  std::vector<TrafficEdge> edges;
  std::vector<TrafficLink> links;
  std::vector<TrafficBeside> beside;
  std::vector<SignalPlan> plans;
  bool left_hand = false;  // traffic keeps left
};

// Links in the order of their keys, with their courses, heights, neighbours and signals.
//
// Courses are smooth: a movement sets out as its lane ends, and ends as the next lane sets out.
// Where two lanes touch, both end in the heading between theirs.  The length of a link is that of
// its line; of a movement between lanes that touch it is a tenth of a micrometre.  The allowed speed of a
// movement is that of the slower of its lanes, but on a bend no more than sqrt(0.7 g r) for its
// tightest radius r, as a metre of it turns.  Movements of one junction, or of
// one node, that need the same ground are conflicts.  Movements go on from lane to lane: one whose lanes are not there is left out.
// Refused (invalid_input): two links of one key, a lane without length or without its edge, a
// neighbour that is no link.
TrafficNetwork traffic_network(const TrafficSource& source);

}  // namespace streetgen
