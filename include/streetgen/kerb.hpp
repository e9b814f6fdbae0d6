// Kerbs: the border of the roadway, as lines with the roadway on their right.  StreetGen
// paper, 2.5.
//
// The border of the roadway of each level, each metre once: what a surface shares with another one
// of its level is none.  An exterior border is walked clockwise, that of a hole counter-clockwise.
#pragma once

#include <optional>

#include "streetgen/beside.hpp"
#include "streetgen/geometry.hpp"
#include "streetgen/method.hpp"

namespace streetgen {

// A part of the border of a section or an intersection; directions are those of the edge.
enum class KerbSide {
  left,             // of a section
  right,            // of a section: its kerbs run against the edge
  start,            // across the start of a section
  end,              // across its end: a dead end, or what an intersection does not cover
  corner_at_start,  // of the intersection where the edge starts, from its left counter-clockwise
  corner_at_end,    // of the intersection where the edge ends, from its right counter-clockwise
  across_start,     // of the intersection where the edge starts, towards its section
  across_end,       // of the intersection where the edge ends, towards its section
};
const char* kerb_side_name(KerbSide side) noexcept;

struct Kerb {
  int edge = 0;
  int node = -1;  // that it is the intersection of; -1: the kerb of a section
  int level = 0;
  KerbSide side = KerbSide::left;
  int part = 1;              // from 1 on each side, in the direction of the kerbs
  Line line;                 // at least two distinct points; closed where it goes all around
  std::optional<Arc> curve;  // where it is the arc of its corner, or a piece of it
  // That of the corner; contested where others take part of the side, and level_change where the
  // roadway goes on on another level.
  Method method = Method::hypothesis;
  double stone_width = 0;         // metres
  Beside beside = Beside::outer;  // what lies behind it
};

// The strip of kerb stones on its left, round about bends, flat at its ends.
MultiPolygon stones_of(const Kerb& kerb);

}  // namespace streetgen
