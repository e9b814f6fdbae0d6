// The ways in which the rows of a model came about.
#pragma once

namespace streetgen {

// The way in which a row came about; the words are those of the `method` columns.
enum class Method {
  hypothesis,       // as wanted
  radius_reduced,   // the wanted radius does not fit the axes: the largest that does
  radius_minimal,   // the arc's centre lay beyond max_arc_distance
  followed,         // an axis is too short: the arc touches the next one in its direction
  nose,             // of a median or an island: the largest radius that paves no more than it may
  no_arc,           // no candidate (one axis within the other, nearly straight), or the ground
                    // between is the middle of dual carriageways that cross
  crossed_limits,   // the limits of the edge would cross: both at their meeting
  transition,       // a change of width
  contested,        // part of the ground belongs to another surface
  crowded,          // very many surfaces claim part of the ground: it went by rank
  robust_fallback,  // the ring was built by union, not piece by piece
  by_hand,          // as an override says
  level_change,     // the roadway goes on there on another level
  covered,          // roadway lies behind an arc, or all over a block
  axis_bound,       // a block beside a street without roadway on its level: the axis bounds it
};
const char* method_name(Method method) noexcept;

}  // namespace streetgen
