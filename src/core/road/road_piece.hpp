// A straight piece or an arc, in the plane or in space.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/box.hpp"
#include "geometry/box_hierarchy.hpp"
#include "streetgen/geometry.hpp"

namespace streetgen {

struct RoadPiece {
  Point origin;
  Point forward;      // unit, at the origin
  Point inward;       // unit, from the origin of an arc to its centre
  double radius = 0;  // 0: straight
  double length = 0;
  double start = 0;  // abscissa of the origin on the road

  bool curved() const { return radius > 0; }
  double angle() const { return curved() ? length / radius : 0; }
  Point centre() const;
  Point point(double at) const;
  Point direction(double at) const;
  Point towards_centre(double at) const;
  Point end() const { return point(length); }
  // Metres along it to the place that is nearest.
  double nearest(const Point& p) const;
  Box box() const;
  // The part between two places.
  RoadPiece part(double from, double to) const;
};

RoadPiece straight_piece(const Point& from, const Point& to);
// Through three distinct points; straight where they lie on a line, a circle where ends are one.
RoadPiece arc_piece(const Arc& arc);

// A place where two pieces of the plane meet, ends included: metres along each.
struct PieceCrossing {
  double a, b;
};
std::vector<PieceCrossing> crossings(const RoadPiece& a, const RoadPiece& b);

// Pieces in a row, found by place.
class PieceIndex {
 public:
  PieceIndex() = default;
  explicit PieceIndex(const std::vector<RoadPiece>& pieces);
  // The piece that is nearest, and metres along it.
  std::pair<std::size_t, double> nearest(const std::vector<RoadPiece>& pieces,
                                         const Point& p) const;
  // Whether one of the pieces from first to last comes nearer to p than `reach`.
  bool comes_within(const std::vector<RoadPiece>& pieces, const Point& p, double reach,
                    std::size_t first, std::size_t last) const;

 private:
  BoxHierarchy boxes_;
};

}  // namespace streetgen
