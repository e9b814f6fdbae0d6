// Signal programs: which movements of a junction have green together, for how long, and what comes
// between.
//
// A program is a cycle of states. Who has green at the same time does not cross and does not merge
// but where a turn gives way, which is then permitted instead of protected. Times of amber and
// between greens follow Wilkie, Sewall and Lin, "Transforming GIS Data into Functional Road Models"
// (2012), section 4.3.1, with the speed of each movement.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace streetgen {

// A movement that asks for green.
struct SignalRequest {
  std::int64_t approach = 0, exit = 0;  // the edges that it comes from and leads to
  std::int64_t lane = 0;                // that it comes from
  enum class Turn { through, left, right, u_turn } turn = Turn::through;
  double length = 0;           // metres across the junction
  double speed = 50;           // km/h of the approach
  int lanes = 1;               // of the approach
  int importance = 5;          // of the approach, 1 the highest
  std::optional<double> flow;  // vehicles an hour that come by the approach
  int precedence = 0;          // who has the smaller number of two that meet goes first
  struct Conflict {
    int movement = 0;  // from 0, that crosses it, merges with it or opposes it
    double reach = 0;  // metres along its own path to where they meet
  };
  std::vector<Conflict> conflicts;
  struct Walk {
    int walk = 0;        // from 0: people on foot in whose way it is, and to whom it does not yield
    double seconds = 0;  // that they need, with the shortest walk signal
    double reach = 0;    // metres along its own path to them
  };
  std::vector<Walk> walks;
};

struct SignalRules {
  double longest_cycle = 120;  // seconds
  double longest_all_red = 6;  // seconds of a change, also where more are asked for
  double step = 1;             // seconds, of which each state lasts a number
  double shortest_walk = 4;    // seconds in which people on foot step on
  int least_importance = 5;    // approaches below it have no phase of their own
  // Whether turns across others of their phase have a phase of their own. Without it: by their
  // lanes, the lanes that they cross, and speed.
  std::optional<bool> turn_phases;
};

enum class SignalKind { green, amber, all_red, walk };
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

// The seconds from the end of one green to the start of another one that it meets.
struct Intergreen {
  int ends = 0, begins = 0;  // movements, or walks
  bool ends_on_foot = false, begins_on_foot = false;
  double seconds = 0;
};

// Few phases: approaches whose through traffic does not meet share one, and their turns give way
// within it, or have a phase before it. Approaches below the least importance have green with
// others, and give way. Between phases come amber and all red, as long as what ends and what begins
// next ask for. Phases follow each other so that all of them do, where an order lets them, and that
// this takes least. People on foot cross in phases
// that leave them room; where none does, in a state of their own.
// Greens are shared out by Webster's rule where flows are known, else by lanes and importance.
// A walk loses its time where the longest cycle is too short for it beside one phase. Turns lose
// their phases where it is too short for all; then two phases at a time become one in which less
// important approaches give way.
// Edges are told apart by their ids and ordered as they come.
// Every movement has green once a cycle. No movements: no states. Refused (invalid_input): numbers
// that are not finite or out of range, conflicts that name no movement.
std::vector<SignalState> signal_phases(const std::vector<SignalRequest>& movements,
                                       const SignalRules& rules);

// The states of the paper: each pair of roads has green for 20 s, amber and all red within.
std::vector<SignalState> signal_pairs(const std::vector<SignalRequest>& movements,
                                      const SignalRules& rules);

// Between all movements that meet, and between movements and people on foot in whose way they are.
std::vector<Intergreen> intergreens(const std::vector<SignalRequest>& movements,
                                    const SignalRules& rules);

}  // namespace streetgen
