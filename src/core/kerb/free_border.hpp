// The border of a surface that no other surface shares.
#pragma once

#include <utility>
#include <vector>

#include "geometry/box.hpp"
#include "geometry/box_hierarchy.hpp"
#include "geometry/prepared_surface.hpp"
#include "streetgen/geometry.hpp"

namespace streetgen {

// Metres. A long crack between two surfaces that is narrower is no ground: each was computed in its
// own way. So far beyond a border lies who is on its other side, and so near to where two surfaces
// meet a kerb begins.
constexpr double crack = 1e-5;

struct BorderPiece {
  Point from, to;
  bool shared = false;
  bool joins_level = false;  // a surface of another level goes on there
};
// All around one ring.
using BorderLoop = std::vector<BorderPiece>;

// Whether two segments lie on each other over some length, to same_place; over more than a
// millimetre, to ten micrometres.
bool lie_along(const Point& a, const Point& b, const Point& c, const Point& d);

// The border of a surface, with the surface on its right, and who shares it. The surface must
// outlive it unchanged.
class FreeBorder {
 public:
  explicit FreeBorder(const MultiPolygon& surface);

  const Box& box() const { return box_; }
  bool lies_along(const Point& from, const Point& to) const;
  // Shares sides where parts of the surface touch each other; it comes after the neighbours.
  void share_with_itself();
  // Shares sides with a neighbour of the same level, or of the other one where the roadway goes on.
  void share_with(const MultiPolygon& neighbour, bool other_level);
  // With a surface that may overlap this one: also where it holds the ground beyond the border.
  void share_with_claim(const MultiPolygon& neighbour);
  // The rings, cut where sharing begins and ends: at vertices of this surface or of another one.
  std::vector<BorderLoop> loops() const;

 private:
  struct Stretch {
    std::size_t side;
    double first, last;  // shares of its length
    Point from, to;
    bool other_level;
  };
  void add_shared(std::size_t side, const Point& from, const Point& to, bool other_level);
  void keep_longest(std::size_t first, const Point& along);
  bool is_shared(const Stretch& stretch, std::size_t first) const;
  void append_pieces(std::size_t side, const Stretch* first, const Stretch* last,
                     BorderLoop& loop) const;
  std::pair<Point, Point> side(std::size_t i) const { return {sides_[i][0], sides_[i][-1]}; }

  std::vector<const Point*> sides_;  // where each begins, ring after ring: its end stands before it
  std::vector<std::size_t> ring_ends_;
  Box box_;
  BoxHierarchy boxes_;
  std::vector<Stretch> stretches_;
};

}  // namespace streetgen
