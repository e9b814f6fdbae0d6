// Plain geometry values.  All coordinates and lengths are metres in one projected,
// planar coordinate system; angles are radians, counter-clockwise positive.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace streetgen {

// z is carried by axes, nodes and edges; every construction is planar and ignores it.
struct Point {
  double x = 0;
  double y = 0;
  double z = 0;
};

using Line = std::vector<Point>;

// Closed: the last point repeats the first.
using Ring = std::vector<Point>;

// Exterior ring first (counter-clockwise), then holes (clockwise).
using Polygon = std::vector<Ring>;

// Empty when there is no surface.
using MultiPolygon = std::vector<Polygon>;

// Counter-clockwise seen from above.
using Triangle = std::array<Point, 3>;

// A circular arc through three points: start, a point on the arc, end.
struct Arc {
  Point start;
  Point middle;
  Point end;
};

// One piece of a curved ring: a straight segment when `curved` is false (middle unused).
struct RingPiece {
  Arc arc;
  bool curved = false;
};
using CurvedRing = std::vector<RingPiece>;

// The same of a line: each piece starts where the one before it ends.
using CurvedLine = std::vector<RingPiece>;

}  // namespace streetgen
