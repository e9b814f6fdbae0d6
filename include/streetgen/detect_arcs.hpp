// Arcs of circles in a line: a Hough vote of quadruplets of points, then a fit.  StreetGen paper,
// section 2.8.
#pragma once

#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

struct ArcBounds {
  double radius_least = 2;      // metres, positive
  double radius_greatest = 80;  // metres
  double tolerance = 0.3;       // metres by which a point may leave its arc, positive
  double turn_least = 30;       // degrees, 0 to 360: an arc turns as far about its centre
};

struct DetectedArc {
  Point centre;
  double radius = 0;     // metres
  Arc arc;               // in the direction of the line; a full circle ends where it starts
  int support = 0;       // points of the line on the arc, four or more
  double deviation = 0;  // metres, the greatest of these points
};

// Arcs come in the order of the line, and a point lies on at most one, but where two meet.  A
// closed line has no beginning: an arc may go on over its start.  The turn of an arc is spread over
// its points: none of them has more than 60 degrees, or more than 0.45 of all.  The turn at a point
// is taken between points so far about it that the noise of points hardly turns the line there. The
// points lie off the arc, by their squares, by at most a tenth of its height over its chord (of
// half the circle at most).  The chord between points more than 3 m apart leaves the arc by at most
// twice the tolerance, so that corners of blocks make no arc.  Ends that leave the circle of the
// others by far more than these do lie on the tangents before and behind it, and are no part of the
// arc. The centre is that of the least squares of distances.  With noise of e metres in n points
// that turn by a, its error is about 10 e / (a^2 sqrt(n)), a in radians, and half of that from a
// half circle on.  A line with less than four distinct points has no arc.
std::vector<DetectedArc> detect_arcs(const Line& line, const ArcBounds& bounds);

}  // namespace streetgen
