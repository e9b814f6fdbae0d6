// The ways over the edges inside a junction, from one of its legs to the others.
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
  // `kind`: no way takes a turn or an edge that is forbidden to such traffic; without: neither is
  // asked.
  JunctionRoutes(const JunctionPlace& place, double node_tolerance, std::optional<LaneKind> kind);

  // By leg; none where no way leads there.  By edge and not by node: a way may pass a node twice.
  std::vector<std::optional<JunctionRoute>> from(int leg) const;

 private:
  // An edge inside or a leg, as a turn at a node begins or ends with it.
  struct Arm {
    std::int64_t axis_id = 0;
    int edge = 0;
    Point heading;
  };
  // By restriction via edges how far a way follows it: 0 not at all, 1 on the axis that it leads
  // from, 1 + i past the i-th of its edges.
  using Followed = std::vector<int>;

  Arm arm_of(int state, bool at_start) const;
  Arm arm_of_leg(int leg, bool comes_in) const;
  int first_node(int state) const;
  int last_node(int state) const { return first_node(state ^ 1); }
  bool open(int state) const;
  bool allowed(int node, const Arm& from, const Arm& to, const Followed& followed) const;
  bool turn_allowed(int node, const Arm& from, const Arm& to) const;
  bool way_allowed(const WayRestriction& restriction, int followed, int node, const Arm& to) const;
  int ends_at(int node, std::int64_t axis_id) const;
  bool touches(int node, int edge) const;
  Followed follow(Followed followed, const Arm& arm) const;

  const JunctionPlace& place_;
  double node_tolerance_;
  std::optional<LaneKind> kind_;
  std::vector<TurnRestriction> turns_;  // those that bind the traffic
  std::vector<WayRestriction> ways_;
};

}  // namespace streetgen
