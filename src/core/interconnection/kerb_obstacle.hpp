// The kerbs of an intersection, which a path about its node may not cross.
#pragma once

#include <vector>

#include "geometry/box.hpp"
#include "streetgen/geometry.hpp"

namespace streetgen {

// Metres from the middle of a car to its side: the clearance that a path wishes for.
constexpr double half_car = 0.9;

// The boundary of an intersection.  Where it runs along a border line a path may leave it: onto
// the section behind.
class Kerbs {
 public:
  // border_lines: two points each.
  Kerbs(const MultiPolygon& intersection, const std::vector<Line>& border_lines);

  // Whether the path crosses a kerb, or a border line other than the two at these places in the
  // list, or comes nearer to a kerb than `clearance`.
  bool stop(const Line& path, int border_in, int border_out, double clearance = 0) const;

  // Places so far off the kerbs, and from each other at least, where kerbs bulge into the
  // intersection: a shortest way past them bends there.
  std::vector<Point> bulges(double clearance) const;

 private:
  struct Piece {
    Point start, end;
    Box box;
    int border = -1;       // the border line that it runs along; -1: it is a kerb
    std::size_t next = 0;  // the piece that follows, the intersection on the left of both
  };
  Point middle_of_pieces() const;

  std::vector<Piece> pieces_;
};

}  // namespace streetgen
