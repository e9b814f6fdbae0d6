// Curves as polylines.
#pragma once

#include "streetgen/geometry.hpp"

namespace streetgen {

// The curve in the plane; chords leave its arcs by at most a millimetre.
Line curve_chords(const CurvedLine& curve);

}  // namespace streetgen
