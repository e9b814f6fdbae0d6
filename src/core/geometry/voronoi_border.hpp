// Whose site is nearest: ground between two owners.
#pragma once

#include <utility>
#include <vector>

#include "geometry/box.hpp"
#include "geometry/box_hierarchy.hpp"
#include "streetgen/geometry.hpp"

namespace streetgen {

struct Site {
  Point point;
  bool first = true;  // belongs to the first of two owners
};

// The Voronoi cells of the sites, told apart by owner, as far as a box shows them.  Of sites in one
// place (10 micrometres) the earlier one counts.
class VoronoiBorder {
 public:
  VoronoiBorder(const std::vector<Site>& sites, const Box& within);  // one site or more

  // Of a place in the box.
  bool first_owns(const Point& place) const;
  // The edges between cells of different owners that come into the box, and what of them lies up
  // to a metre outside. Those that go on from each other have an end in common.
  std::vector<std::pair<Point, Point>> border() const;

 private:
  class Edge;

  int size() const { return static_cast<int>(sites_.size()); }
  double square(int site, const Point& p) const;
  template <class Use>
  void each_in(const Box& box, Use use) const;
  int nearest(const Point& p, int end) const;  // of those before `end`
  // And the sites that are as near at its ends.
  Edge edge_between(int first, int second, std::vector<int>& neighbours) const;
  // Pairs on the border, of each of its lines at least one.
  std::vector<std::pair<int, int>> some_pairs() const;

  Box within_;  // from the origin, as all below
  Point origin_;
  std::vector<Site> sites_;
  BoxHierarchy index_;  // of sites
};

}  // namespace streetgen
