// Arc roads: straight pieces and arcs that touch them, made of a polyline. Wilkie, Sewall and Lin,
// "Transforming GIS Data into Functional Road Models for Large-Scale Traffic Simulation", 6.
//
// Each inner point of the polyline is a bend: an arc in the plane of its two segments, tangent to
// both. The first and the last point stay, also where they are one. A point that repeats the one
// before it, or lies on the segment between its neighbours, is no bend. A bend back along the same
// way (in the plan) has no arc: it keeps radius 0, as does one whose radius is asked to be 0.
//
// Abscissas are metres along the road, offsets metres to its left, angles radians. Heights (z)
// count: lengths and arcs are those of space, "left" and "right" are horizontal, and "up" is
// normal to the road. Errors are of kind invalid_input and count points from 1.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

// The bounds of the radii. The radii of the bends are the greatest in this sense: no bend can have
// a greater one unless another one that is not greater than it gets a smaller one.
struct ArcRoadFit {
  double cap = 4000;            // greatest radius, metres
  std::optional<double> shift;  // how far the road may leave a point of the polyline, metres
  // A radius for each point of the polyline, or none; it comes before cap and shift. What is said
  // of points that are no bends has no meaning. Empty: none.
  std::vector<std::optional<double>> radii;
};

// A bend: point(t) = centre + radius (cos t start_direction + sin t orientation x start_direction).
struct RoadArc {
  std::size_t vertex = 0;  // index of the point in the polyline
  Point centre;
  double radius = 0;  // 0: the bend stays sharp
  double angle = 0;
  double start_abscissa = 0, end_abscissa = 0;
  Point start_direction;  // unit vector from the centre to the start of the arc
  Point orientation;      // unit normal of the plane: up on left bends, down on right ones
};

struct RoadPlace {
  Point point;
  Point forward, right, up;  // unit vectors; right is horizontal, up = right x forward
  double heading = 0;        // counter-clockwise from the x axis
  double curvature = 0;      // 1/m, the horizontal part: positive on left bends
};

struct RoadFoot {
  double abscissa = 0;  // of the place of the road that is nearest, the first of equal ones
  double offset = 0;    // to the left of the road there
  double distance = 0;  // from the road
};

class ArcRoad {
 public:
  // Refuses coordinates and radii that are not finite, negative radii, a list of another length,
  // radii that do not fit, a line without length and vertical pieces.
  static ArcRoad fit(const Line& line, const ArcRoadFit& fit = {});

  // The road along a curve; an arc runs through its three points, in space where they have
  // heights. An arc that returns to its start is a circle, counter-clockwise.
  static ArcRoad along(const CurvedLine& curve);

  double length() const;
  // Whether all of it lies at one height.
  bool flat() const;
  // A row for each bend of a road that was fitted.
  const std::vector<RoadArc>& arcs() const;
  CurvedLine curve() const;
  // The pieces from where they begin, and their signed radii: positive on left bends, 0 of straight
  // pieces.
  struct Stretch {
    double start_abscissa = 0, end_abscissa = 0, radius = 0;
  };
  std::vector<Stretch> stretches() const;
  // The arcs in their order; the corner is where the straight lines before and after would meet.
  struct Bend {
    Stretch stretch;
    Point centre, corner;
    Arc arc;
  };
  std::vector<Bend> bends() const;
  // A place where the heading jumps, at an end of an arc. No jump is a turn of a thousandth of a
  // radian, or a turn that ten nanometres make at the end of a short piece.
  struct Kink {
    Point place;
    double angle = 0;
  };
  std::vector<Kink> kinks() const;

  // Clamped to the road.
  RoadPlace at(double abscissa) const;
  // Heights do not count of a road that is flat.
  RoadFoot locate(const Point& point) const;

  // The road at an offset; none where nothing is left. Exact where the road is flat: straight
  // pieces and arcs about the same centres, and what an inner bend turns over is cut out as of
  // kerbs. In space it bends where the road does, at the heights of the bends. There it lies
  // within |offset| slope (1 + tan(angle / 2)) of the true place beside the road, for the
  // greatest slope (rise / run, below 0.2) and the sharpest bend of the line it was fitted to
  // (angle in the plan). An inner bend in space that is tighter than the offset is refused.
  std::optional<ArcRoad> offset(double axis_offset) const;

  // Chords that leave the road by at most the tolerance.
  Line line(double tolerance) const;

  // The surface between two offsets, left > right, as a strip of triangles. Both borders have a
  // point at each step and leave the true ones by at most the tolerance; one that an inner bend
  // turns over stays where it meets itself.
  std::vector<Triangle> mesh(double offset_left, double offset_right, double tolerance) const;

 private:
  using Body = std::shared_ptr<const struct RoadBody>;
  explicit ArcRoad(Body body) : body_(std::move(body)) {}
  friend class RoadBuilder;
  Body body_;
};

// The greatest speed in km/h at which a car does not slip on an arc (equation 7), banked inwards
// by a superelevation (rise / run), times a factor of safety; friction is that of tyre and road.
double arc_speed_limit(double radius, double friction, double superelevation, double safety);

}  // namespace streetgen
