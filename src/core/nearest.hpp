// Whose axis is nearest: ground between two owners.
#pragma once

#include <utility>
#include <vector>

#include "box_runs.hpp"
#include "front.hpp"
#include "overlap.hpp"
#include "streetgen/geometry.hpp"

namespace streetgen {

// Of places in a box, none of which lies farther than `reach` from an axis of either owner.  Where
// axes of the other lie on those of the leader, to a tenth of a millimetre, the leader's count.
// The pieces are as seen from the origin; box, places and border are not.
class NearestOwner {
 public:
  NearestOwner(const std::vector<Straight>& of_leader, const std::vector<Straight>& of_other,
               const Point& origin, const Box& within, double reach);

  bool leader_owns(const Point& place) const;
  // The places as near to both, in segments that leave them by a millimetre at most: those that
  // come near the box.  Those that go on from each other have an end in common.
  std::vector<std::pair<Point, Point>> border() const;

 private:
  struct Axes {
    std::vector<Straight> pieces;
    BoxRuns index;  // of them

    explicit Axes(std::vector<Straight> pieces);
    double square_from(const Point& p) const;
  };

  void append_border(Front& front, const Box& base,
                     std::vector<std::pair<Point, Point>>& border) const;

  Point origin_;
  Box within_;  // from the origin, as all below
  double reach_;
  Axes leader_, other_;
};

}  // namespace streetgen
