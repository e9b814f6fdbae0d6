// The faces that lines make where they cross or touch.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/grid_cell.hpp"
#include "streetgen/geometry.hpp"

namespace streetgen {

// A line that lies elsewhere, or part of one.
class LineView {
 public:
  LineView(const Line& line) : LineView(line.data(), line.size()) {}
  LineView(const Point* first, std::size_t size) : first_(first), size_(size) {}
  const Point* begin() const { return first_; }
  const Point* end() const { return first_ + size_; }
  std::size_t size() const { return size_; }
  const Point& operator[](std::size_t i) const { return first_[i]; }

 private:
  const Point* first_;
  std::size_t size_;
};

// Lines are noded once, by snap rounding on a grid finer than a micrometre with exact predicates:
// what comes out crosses nowhere, and the same crossing is the same point in every arrangement. The
// lines' own vertices stay where they are; of two in one place of the grid the first holds for
// both. Hobby, Practical segment intersection with finite precision output, 1999.
class Arrangement {
 public:
  // What is asked afterwards: a place in each face, or the way of each line along the faces.
  enum class Asked { places, ways };
  explicit Arrangement(const std::vector<LineView>& lines, Asked asked = Asked::places);

  // A place in the face beside each walk along its border; a face with islands has several.
  const std::vector<Point>& places() const { return places_; }

  // The sides of all segments between places where lines end, bend, meet or cross.  Side `side ^ 1`
  // is the other side of the same segment, and runs the other way.
  int side_count() const { return static_cast<int>(halves_.size()); }
  int walk_count() const { return static_cast<int>(walks_.size()); }
  int walk_of(int side) const { return halves_[side].walk; }
  // Where the side begins.
  const Point& start_of(int side) const { return nodes_[halves_[side].from].point; }
  // The sides of a walk, in their order.
  std::vector<int> sides_of(int walk) const;
  // The sides along a line that has the faces on its left, in the line's order.  Lines that lie on
  // each other share sides.
  std::vector<int> way(int line) const;
  // Square metres, exact to rounding: positive of a walk that goes about its face, and not of one
  // that goes about an island.
  std::vector<double> areas() const;
  // For each walk about an island the walk about the face that holds the island; -1: none does.
  // For a walk about its face the walk itself.
  std::vector<int> faces_of_walks() const;

  // The walk on whose left the place lies: counter-clockwise, but about an island.
  Ring border(int walk) const;

  // The faces whose walks are kept, as one. With the lines' own vertices rings that nearly touch
  // may cross by less than a step; on the grid they do not.
  enum class Vertices { own, on_grid };
  MultiPolygon joined(const std::vector<bool>& kept, Vertices vertices = Vertices::own) const;

 private:
  struct Node {
    GridCell cell;
    Point point;
  };
  // From a node to the next; its twin, the way back, has the index ^ 1.
  struct Half {
    int from, to;
    int next = -1;  // along the face on its left
    int walk = -1;
  };

  void node(const std::vector<LineView>& lines, Asked asked);
  std::vector<int> number(const std::vector<GridCell>& places,
                          const std::vector<const Point*>& points);
  void connect();
  void walk();
  int outer_walk() const;
  void place_walks();
  Point on_grid(const GridCell& cell) const;
  bool walk_holds(int walk, const GridCell& cell) const;
  std::vector<int> islands() const;

  double step_ = 0;  // metres
  Point origin_;
  std::vector<Node> nodes_;
  std::vector<Half> halves_;
  std::vector<int> around_;  // by half: the next one clockwise about its `from`
  std::vector<int> walked_;  // halves, walk by walk
  std::vector<int> walks_;   // where each ends in these
  std::vector<Point> places_;
  std::vector<int> way_sides_;  // halves, line by line
  std::vector<int> ways_;       // where each line's end in these
};

}  // namespace streetgen
