// The movements of a node as ways of their approaches, and what is asked of them.
#pragma once

#include <vector>

#include "interconnection/movement.hpp"

namespace streetgen {

// The lanes of a leg that lead as those of one kind, by their index among all; those in the middle
// apart.
using Group = std::vector<int>;

Group group_of(const std::vector<LaneEnd>& lanes, LaneKind kind);
Group middle_of(const std::vector<LaneEnd>& lanes);
// The lanes in which those of a kind go on: lanes of their kind, else the general ones.
Group targets(const Leg& leg, LaneKind kind);

// One movement as its approach sees it.
struct Way {
  Movement* movement;
  const Leg *from, *to;
  double angle;   // of the movement; one that turns back is the outermost on its side
  double order;   // the greater, the farther to the left: by the angle and by where it leads
  Group goals{};  // where lanes of the kind that is assigned go on

  std::size_t pair(int in, int out) const { return in * to->out.size() + out; }
  Verdict& at(int in, int out) const { return movement->verdicts[pair(in, out)]; }
  bool drivable(int in, int out) const { return movement->drivable[pair(in, out)]; }
  bool turns_back() const { return movement->turns_back; }
  bool forbidden(int in, int out) const;
  bool tight(int in, int out) const;
  bool nearly_straight() const;
  // Steps of an angle from the way straight on, a change of importance set against the angle.
  long long off_course() const;
};

using Ways = std::vector<Way>;

// The ways of a node, with room for their verdicts.
Ways ways_of(const std::vector<Leg>& legs, std::vector<Movement>& movements);

// The index of the way that goes on nearest to straight; -1: there is none.
int way_through(const Ways& ways);
// Whether a street goes on as another, and neither leads elsewhere.
bool goes_on_alone(const Ways& of_node, const Way& way);

}  // namespace streetgen
