// Interconnections: how traffic goes on at a node, lane to lane.  StreetGen paper, 2.7.3.
//
// Every lane that comes in is paired with every lane that goes out by another edge (setting
// u_turn: also by the same edge); parking lanes take no part.  A lane for both directions comes in
// and goes out at both its ends.  docs/concepts/geometry.md says how plausible pairs are told from
// the others.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "streetgen/geometry.hpp"
#include "streetgen/lane.hpp"
#include "streetgen/street.hpp"
#include "streetgen/trajectory.hpp"

namespace streetgen {

enum class Turn { through, left, right, u_turn };
const char* turn_name(Turn turn) noexcept;

// Why an interconnection is plausible, or why not.
enum class Reason {
  lane_order,    // the order of the lanes at the node
  turn_lanes,    // the movements marked on the lane
  only_way,      // plausible: else the lane in would lead nowhere or the lane out not be reached
  restriction,   // not: a turn restriction
  lane_kind,     // not: a lane of another kind
  look_ahead,    // plausible: the lane out leads where one turns at a junction just behind
  traffic,       // plausible for some traffic alone: it is excepted, or a street is its own
  u_turn,        // not: it turns back where there are other ways on
  radius,        // not: too tight for the speed where other ways do
  ring,          // not: against the traffic of a roundabout
  not_drivable,  // a corner that no car drives; plausible only where it is the only way
};
const char* reason_name(Reason reason) noexcept;

// From one axis to another at the node that lies within three tolerances of `via`, the nearest
// that both axes meet; one without such a node changes nothing.  `turn` tells the edges of an
// axis that goes on beyond the node apart.  What is forbidden stays so whatever else is allowed.
struct TurnRestriction {
  std::int64_t from_axis = 0;
  std::int64_t to_axis = 0;
  Point via;
  bool only = false;  // the only way on from the edge; else: no way
  std::optional<Turn> turn;
  std::vector<LaneKind> except{};  // it does not bind traffic of these kinds, on whatever lane
};

struct InterconnectionSettings {
  bool u_turn = false;  // also between lanes of one edge
  TrajectoryRule rule = TrajectoryRule::bezier;
  double least_radius = 15;     // metres, see trajectory
  double tolerance = 0.05;      // metres, of the trajectories' chords
  double node_tolerance = 0.5;  // metres, of the network
  std::size_t most = 10000;     // at a node of more pairs of lanes none are made
  DrivingSide driving_side = DrivingSide::right;
  double look_ahead = 25;  // metres of lane, on less of which nobody changes lanes
};

struct Interconnection {
  int node = 0;
  int lane_in = 0;  // index into the lanes
  int lane_out = 0;
  // Whether one drives along the axis of each; another way than lane.along_axis only where both
  // directions use the lane.
  bool along_in = true, along_out = true;
  Turn turn = Turn::through;  // through: the lanes are parallel; u_turn: it turns back
  double angle = 0;           // degrees in (-180, 180] from lane to lane, positive to the left
  bool plausible = false;
  Reason reason = Reason::lane_order;
  LaneKinds traffic{};  // who may take it, by the kinds of lanes; general: all
  Point control;
  Line line;
};

// The lanes that an edge wants, from the left kerb in the direction of its axis.
using WishedLanes = std::function<std::vector<LaneWish>(const Edge&)>;

// Whether lanes leave traffic of a direction a choice that it looks ahead for.
bool leave_choice(const std::vector<LaneWish>& lanes, bool along_axis);

// At affected nodes, by (node, lane_in, lane_out, along_in, along_out).  `lanes` as
// streetgen::lanes gives them, of the same streets; `axes` as the streets were made from.  Onto a
// roundabout, round and off it nobody turns back, however sharp the turn.  Without `wished` nobody
// looks ahead.
std::vector<Interconnection> interconnections(
    const Streets& streets, const std::vector<StreetAxis>& axes, const std::vector<Lane>& lanes,
    const std::vector<TurnRestriction>& restrictions, const InterconnectionSettings& settings,
    const std::vector<Circulation>& circulations = {}, const WishedLanes& wished = {});

// Whoever drives against the traffic of a roundabout is not plausible, reason ring.
void forbid_against_rings(const Streets& streets, const std::vector<Lane>& lanes,
                          const std::vector<Circulation>& circulations,
                          std::vector<Interconnection>& interconnections);

}  // namespace streetgen
