// The body of an arc road, and what makes one.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "road/road_piece.hpp"
#include "streetgen/arc_road.hpp"

namespace streetgen {

struct RoadBody {
  std::vector<RoadPiece> pieces;
  std::vector<double> starts;  // abscissas, beside each other for the search
  std::vector<RoadArc> arcs;
  PieceIndex index;
  Point end;
  double length = 0;
  bool flat = true;
};

class RoadBuilder {
 public:
  // A piece that is shorter than `least` is left out.
  explicit RoadBuilder(double least);
  // Gives the abscissa of its start.
  double add(RoadPiece piece);
  bool empty() const { return body_->pieces.empty(); }
  double length() const { return body_->length; }
  ArcRoad built(const Point& end, std::vector<RoadArc> arcs = {});

 private:
  std::shared_ptr<RoadBody> body_;
  double least_;
};

// Positive where a piece bends to the left, in the plan.
inline double turn_of(const RoadPiece& piece) {
  return piece.forward.x * piece.inward.y - piece.forward.y * piece.inward.x;
}

// A quarter turn to the left of a direction, horizontal and of length one.
Point leftwards(const Point& direction);

// The angle over one chord that leaves an arc by the tolerance.
double chord_angle(double radius, double tolerance);

// The number of equal chords that span an angle so.
std::size_t chord_count(double angle, double radius, double tolerance);

// The surface between two offsets of a road, of pieces.
std::vector<Triangle> road_mesh(const RoadBody& road, double offset_left, double offset_right,
                                double tolerance);
// The road at an offset: exact of a flat one, at the heights of its bends of one in space.
std::optional<ArcRoad> flat_offset(const RoadBody& road, double axis_offset);
ArcRoad offset_in_space(const RoadBody& road, double axis_offset);

}  // namespace streetgen
