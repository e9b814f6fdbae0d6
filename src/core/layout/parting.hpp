// What parts two sections that begin before the place at which their kerbs part.
#pragma once

#include <optional>
#include <vector>

#include "layout/arm.hpp"

namespace streetgen {

// The border of a section beside such a neighbour: from the border line to the arc, and along the
// arc to the section's own kerb.
struct Parting {
  Line line;
  double until = 0;  // metres along the axis, of the arc's end

  // Between the axis, from a limit on, and the line.
  Ring ground(const Line& axis, double limit) const;
};

// Those of a section, by its sides; +1: left, -1: right.
struct SectionPartings {
  struct Side {
    std::optional<Parting> at_start, at_end;  // from either border line
  };
  Side left, right;

  const Side& on(int side) const { return side > 0 ? left : right; }
  Side& on(int side) { return side > 0 ? left : right; }
  std::vector<Parting> all() const;
};

// Between two streets whose kerbs cross, at a share of the way from the node to that crossing: as
// far from their axes as each is wide.
Point place_between(const Arm& a, const Arm& b, const CornerArc& crossing, double share);

// Between the sections of two arms, from the crossing of their border lines by that of their kerbs
// to a vertex of the arc; empty where there is none.
Line parting_line(const Arm& a, const Arm& b, const Gap& gap);

// Along the parting line of a gap, seen from the node: of its first arm or of the second.
Parting parting_of(const Gap& gap, bool first);

// Whether a place is on the section of an arm, up to which an intersection need not reach.
bool beyond_limit(const Arm& arm, const Point& place);

}  // namespace streetgen
