// Kinks of kerbs give way to arcs.
#pragma once

#include <vector>

#include "geometry/geos.hpp"
#include "streetgen/geometry.hpp"

namespace streetgen {

// Each vertex at which the line turns by more than 30 degrees becomes an arc of `radius`, tangent
// to both sides, or the largest one for which there is room. A side between two such vertices gives
// half of its length to each, and an arc stays clear of `borders`. The ends of the line stay.
Line with_round_kinks(const Line& line, double radius, const std::vector<Line>& borders);

// The same of each ring of a surface, clear of its other rings. A surface of which a ring would
// cross itself then stays as it is.
void round_kinks(Geos& geos, MultiPolygon& surface, double radius,
                 const std::vector<Line>& borders);

}  // namespace streetgen
