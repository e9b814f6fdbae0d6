// Geometries as PostGIS 3 stores them (GSERIALIZED, second form), its varlena head included: what
// is written so is a geometry, and nothing has to read it first.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "streetgen/geometry.hpp"
#include "value/wkb.hpp"

namespace streetgen::pg {

using Stored = std::unique_ptr<char[]>;

Stored stored_point(const Point& point, Form form);
Stored stored_line(const Line& line, Form form);
Stored stored_surface(const MultiPolygon& surface, Form form);  // MULTIPOLYGON

// The EWKB of a point or a curve; of another geometry its head alone, which tells the type. Takes
// what comes after the varlena head, of the first form too.
std::string wkb_of_stored(std::string_view stored);

}  // namespace streetgen::pg
