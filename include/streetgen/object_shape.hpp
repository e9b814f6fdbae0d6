// Objects at streets as shapes of few triangles.
#pragma once

#include <string>
#include <vector>

#include "streetgen/surface_mesh.hpp"

namespace streetgen {

// The parts of a shape about its foot, metres: x to the east, y to the north, z up. What it is
// turned to, as the face of a sign, looks to the north. Textures are not counted.
struct ObjectShape {
  SurfaceMesh post;
  SurfaceMesh head;  // in the colour of its kind
};

// The shape of a kind as a drawing tells objects apart: tree, lamp, traffic_light, sign, bus_stop,
// tram_stop, protection (a bollard), furniture (a box); signal is one that hangs over its lane; a
// pole for any other word. Empty for what lies in the ground or is paint: manhole, arrow, calming.
ObjectShape object_shape(const std::string& kind);

}  // namespace streetgen
