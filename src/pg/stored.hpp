// Geometries as PostGIS 3 stores them (GSERIALIZED, second form), its varlena head included: what
// is written so is a geometry, and nothing has to read it first.
#pragma once

#include <string>

#include "streetgen/geometry.hpp"
#include "wkb.hpp"

namespace streetgen::pg {

std::string stored_point(const Point& point, Form form);
std::string stored_line(const Line& line, Form form);
std::string stored_surface(const MultiPolygon& surface, Form form);  // MULTIPOLYGON

}  // namespace streetgen::pg
