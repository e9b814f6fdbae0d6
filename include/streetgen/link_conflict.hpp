// Movements of a junction that need the same ground, and who waits for whom.
#pragma once

#include <cstdint>
#include <vector>

#include "streetgen/interconnection.hpp"
#include "streetgen/traffic.hpp"

namespace streetgen {

// The usual car, as conflicts have it.  Its rear axle is on the course of the link, its front
// swings out where that bends.  Metres.
constexpr double usual_car_length = 5, usual_car_width = 1.8;
constexpr double usual_axle_to_front = 3.9, usual_axle_to_rear = 1.1;

// A movement, and what is known of its right of way.
struct ConflictMovement {
  std::int64_t junction = 0;  // or node; movements of one stand together
  std::int64_t lane_in = 0, lane_out = 0;  // who comes from one lane or uses it the other way
  bool along_in = true, along_out = true;  // whether one drives along the axis there
  double length = 0;                       // metres, positive
  double width = 3.5;                      // of its lane, metres, positive: a car is no wider
  std::vector<LinkPiece> course;           // at least one piece
  Turn turn = Turn::through;
  int rank = 0;        // of two without a common signal the smaller one goes first
  int importance = 0;  // of equal ones that do not come towards each other, too
  int precedence = 0;  // of two that have green together, too
  // The states of the junction's program in which it has green, a bit each; none: it has no signal.
  std::uint64_t protected_states = 0, permitted_states = 0;
};

enum class ConflictKind : std::uint8_t {
  crossing,
  merging,   // they lead into one lane
  opposing,  // one enters a lane for both directions that the other leaves
};

struct MovementConflict {
  int first = 0, second = 0;  // indices, ascending
  ConflictKind kind = ConflictKind::crossing;
  Precedence precedence = Precedence::by_arrival;  // of the first
  // The stretch of each on which a car stands on ground that the other one needs, metres along it.
  // Its front comes there at 0 or more, and its rear leaves up to a car's length beyond the end.  Who
  // merge, and who enters the lane of an opposing one, need it up to the end; from there on each is
  // the leader of who follows.
  double first_from = 0, first_to = 0;
  double second_from = 0, second_to = 0;
};

// The pairs of movements of a junction that need the same ground, by (first, second).  Those that
// come from one lane are none: they follow each other.  Lanes are thought straight on beyond both
// ends of a movement.  A stretch may be longer than needed by half a metre or so, and never
// shorter.
//
// Precedence: who never have green together, by signal.  Who have: who is protected while the other
// is permitted, then who has the smaller `precedence`.  Else the smaller rank.  Of equal ones, who
// turns across the traffic that comes towards gives way to it, and who turns back to all.  Of those
// that do not come towards each other, the smaller importance, then who comes from the right by 15
// degrees or more.  Nothing of that: by arrival.
// A pair that would close a circle of movements that wait for each other goes by arrival, those of
// the last rules first.  `left_hand`: traffic keeps left, and turns across oncoming to the right.
//
// Refused (invalid_input): a length or width that is not positive and finite, up to 10 km; a course
// without a piece, or with a number that is not finite; movements of one junction that stand apart.
std::vector<MovementConflict> link_conflicts(const std::vector<ConflictMovement>& movements,
                                             bool left_hand = false);

}  // namespace streetgen
