// Geometries as EWKB, the form of PostGIS' casts to and from bytea.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen::pg {

struct ReadLine {
  Line line;
  int srid = 0;
  bool has_z = false;
};

// A LINESTRING of two points or more, or a MULTILINESTRING of one part, with finite coordinates
// and two distinct points; M is refused.  `what` opens the message of each Error{invalid_input}.
ReadLine read_line(std::string_view wkb, const std::string& what);

// The vertices of a LINESTRING, which may be none or all in one place.
Line read_vertices(std::string_view wkb, const std::string& what);

struct ReadPoint {
  Point point;
  int srid = 0;
  bool has_z = false;
};

// A POINT that is not empty, refused as a line is.
ReadPoint read_point(std::string_view wkb, const std::string& what);

struct ReadCurve {
  CurvedLine curve;
  int srid = 0;
  bool has_z = false;
};

// A COMPOUNDCURVE, CIRCULARSTRING or LINESTRING that is not empty, refused as a line is.
ReadCurve read_curve(std::string_view wkb, const std::string& what);

// A MULTIPOLYGON in the plane, refused as a line is.
MultiPolygon read_surface(std::string_view wkb, const std::string& what);

struct Form {
  int srid = 0;
  bool has_z = false;
};
std::string write_point(const Point& point, Form form);
std::string write_line(const Line& line, Form form);
std::string write_arc(const Arc& arc, Form form);             // CIRCULARSTRING
std::string write_surface(const MultiPolygon& s, Form form);  // MULTIPOLYGON
std::string write_polygon(const MultiPolygon& s, Form form);  // POLYGON where there is one part
std::string write_curved(const CurvedRing& ring, Form form);  // CURVEPOLYGON
std::string write_curve(const CurvedLine& curve, Form form);  // COMPOUNDCURVE
std::string write_tin(const std::vector<std::array<Point, 3>>& triangles, int srid);  // TIN Z

}  // namespace streetgen::pg
