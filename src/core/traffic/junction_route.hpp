// The way over the edges inside a junction, from one of its legs to another.
#pragma once

#include <optional>
#include <vector>

#include "streetgen/junction_movement.hpp"

namespace streetgen {

// An edge inside, driven along its line or against it.
struct RoutePiece {
  int inner = 0;  // index into JunctionPlace::inner
  bool along = true;
};
using JunctionRoute = std::vector<RoutePiece>;  // empty: both legs meet at one node

// The shortest ways from a leg to all others.
class JunctionRoutes {
 public:
  // `obeyed`: no way takes a turn that a restriction forbids to general traffic.
  JunctionRoutes(const JunctionPlace& place, double node_tolerance, bool obeyed);

  // None where no way leads to the leg.  By edge and not by node: a way may pass a node twice.
  std::optional<JunctionRoute> between(int from_leg, int to_leg) const;

 private:
  bool allowed(int node, std::int64_t from_axis, std::int64_t to_axis) const;
  double size(int inner) const;

  const JunctionPlace& place_;
  double node_tolerance_;
  bool obeyed_;
};

}  // namespace streetgen
