// Signal programs: which movements of a junction have green together, for how long, and what comes
// between.
//
// A program is a cycle of states. Who has green at the same time does not cross and does not merge
// but where a turn gives way, which is then permitted instead of protected. Times of amber and of
// all red follow Wilkie, Sewall and Lin, "Transforming GIS Data into Functional Road Models"
// (2012), section 4.3.1, with the speed of each movement.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace streetgen {

// A movement that asks for green.
struct SignalRequest {
  std::int64_t approach = 0, exit = 0;  // the edges that it comes from and leads to
  enum class Turn { through, left, right, u_turn } turn = Turn::through;
  double length = 0;           // metres across the junction
  double speed = 50;           // km/h of the approach
  int lanes = 1;               // of the approach
  int importance = 5;          // of the approach, 1 the highest
  std::optional<double> flow;  // vehicles an hour that come by the approach
  double walk_in = 0;          // seconds that people need to cross the approach; 0: nobody does
  double walk_out = 0;         // and the edge that it leads to
  std::vector<int> conflicts;  // movements, from 0, that cross it, merge with it or oppose it
};

enum class SignalKind { green, amber, all_red };
enum class RightOfWay { protect, permit };

struct SignalState {
  SignalKind kind = SignalKind::green;
  double duration = 0;  // seconds
  struct Green {
    int movement = 0;
    RightOfWay right_of_way = RightOfWay::protect;
  };
  std::vector<Green> greens;  // of a green state
};

// Few phases: approaches whose through traffic does not meet share one, and their turns give way
// within it. After each phase come amber and all red, which lasts until the last car has left.
// Greens are shared out by Webster's rule where flows are known, else by lanes and importance.
// Where all streets share one phase, all red lasts as long as people need to cross them.
// Edges are told apart by their ids and ordered as they come.
// Every movement has green once a cycle. No movements: no states. Refused (invalid_input): numbers
// that are not finite or out of range, conflicts that name no movement.
std::vector<SignalState> signal_phases(const std::vector<SignalRequest>& movements);

// The states of the paper: each pair of roads has green for 20 s, amber and all red within.
std::vector<SignalState> signal_pairs(const std::vector<SignalRequest>& movements);

}  // namespace streetgen
