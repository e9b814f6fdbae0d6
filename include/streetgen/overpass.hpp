// Overpasses: where two edges cross without a node.  Wilkie, Sewall, Lin, section 5.
//
// Every crossing counts once, also one at a vertex.  One within the tolerance of a node that both
// edges share is that node, and edges that run along each other do not cross.  The upper one is, in
// this order: what a user decides, the higher level, the more important axis, the longer axis (by
// the millimetre), the greater axis_id; of one axis what is nearer to its middle, then the later.
// The relation has no cycle but by hand: two edges and the lengths of their axes decide.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "streetgen/network.hpp"

namespace streetgen {

enum class OverpassMethod {
  by_hand,     // decided by a user
  level,       // the levels of the axes differ
  importance,  // of one level: the more important axis is above
  order,       // of one level and importance: the longer axis is above
};

// By hand: axis_above passes over axis_below at the crossing nearest to `place`, within 20 m,
// so that an axis that is moved a little keeps it.  One without its crossing changes nothing; of
// two for one crossing the later holds.
struct OverpassOverride {
  Point place;
  std::int64_t axis_above = 0;
  std::int64_t axis_below = 0;
  std::optional<double> clearance{};  // metres; none: the model's
};

struct Overpass {
  int edge_above = 0;         // index into Network::edges
  int edge_below = 0;         // equal to edge_above where a loop of one edge crosses itself
  double abscissa_above = 0;  // metres along the edge
  double abscissa_below = 0;
  Point point;
  double clearance = 0;  // metres wanted from roadway to roadway
  OverpassMethod method = OverpassMethod::level;
};

// Sorted by (edge_above, abscissa_above, edge_below).  One per edge: `importances`, 1 is the
// highest, and `axis_lengths`, metres of the input axis.  tolerance (of the network) and clearance
// in metres, not negative.
std::vector<Overpass> overpasses(const Network& network, const std::vector<int>& importances,
                                 const std::vector<double>& axis_lengths,
                                 const std::vector<OverpassOverride>& by_hand, double tolerance,
                                 double clearance);

}  // namespace streetgen
