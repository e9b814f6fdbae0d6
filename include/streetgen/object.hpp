// Places beside an axis: what stands at a street is found by metres along the axis and beside it.
#pragma once

#include <optional>

#include "streetgen/geometry.hpp"
#include "streetgen/width_profile.hpp"

namespace streetgen {

struct PlaceBeside {
  double abscissa = 0;  // metres along the axis, from 0 to its length
  double offset = 0;    // metres beside it, positive to the left
};

struct StandingPlace {
  Point point;
  double direction = 0;  // of the axis there, radians clockwise from the y axis, 0 to 2 pi
};

// The place `offset` from the axis along its normal at an abscissa, which is clamped to the axis.
// At a vertex, within a nanometre, the normal halves the angle between those of both segments. The
// axis has at least two different points.
StandingPlace place_beside(const Line& axis, const PlaceBeside& beside);

// The nearest place of the axis, the first of equal ones, and how far to the left of it the point
// lies. place_beside gives the point back, but for points that are nearest to a vertex or an end:
// these come to lie on the normal there, as far from the axis.
PlaceBeside beside_axis(const Line& axis, const Point& point);

// A stretch of the border of a roadway, or of the line so far beside this border.
struct BorderStretch {
  double from = 0, to = 0;  // metres along the axis, from below to
  int side = +1;            // +1: left of the axis, -1: right
  double beside = 0;        // metres from the border, positive away from the roadway
};

// The stretch as a line in the direction of the axis, between borders that run as far from the axis
// as the profile says. Empty where the stretch is no longer than a micrometre.
Line roadway_border(const Line& axis, const WidthProfile& borders, const BorderStretch& stretch);

// A pedestrian crossing of a street.
struct StreetCrossing {
  double abscissa = 0;  // metres along the axis, of its middle
  double width = 4;     // metres between its borders
  double angle = 0;     // radians from the direction of the axis to the way across, in (0, pi)
};

// The roadway under a crossing, between borders that run as far from the axis as the profile says;
// none where the crossing meets no border. Beyond the ends of the axis all goes straight on.
std::optional<Polygon> crossing_ground(const Line& axis, const WidthProfile& borders,
                                       const StreetCrossing& crossing);

// The paint of a crossing is stripes along the axis; the same between two lines across; the lines
// alone; the lines broken into dashes; or dots along them.
enum class CrossingPaint { zebra, ladder, lines, dashes, dots };

// Its paint. Stripes, dashes and dots: half a metre of paint, half a metre of roadway, from the
// middle of the roadway outwards, and a quarter of a metre free at its borders. Those are left out
// that the axis bends too sharply for, and those are one that lie on each other in a bend.
MultiPolygon crossing_stripes(const Line& axis, const WidthProfile& borders,
                              const StreetCrossing& crossing,
                              CrossingPaint paint = CrossingPaint::zebra);

}  // namespace streetgen
