// The ground of faces: rings of kerbs become polygons.
#pragma once

#include <vector>

#include "block/kerb_loop.hpp"
#include "network/face.hpp"
#include "streetgen/geometry.hpp"

namespace streetgen {

struct FaceGround {
  MultiPolygon surface;
  bool by_faces = false;  // the rings cross or touch themselves, and were cut into faces
};

// The ground of one face: each loop in it is all around ground, or around roadway within ground.
FaceGround ground_of(const std::vector<const KerbLoop*>& loops);

// The ground of several faces between which a street has no roadway: there the edges part it.  The
// loops are all there are.
std::vector<MultiPolygon> ground_of(const std::vector<const Face*>& faces,
                                    const std::vector<KerbLoop>& loops);

}  // namespace streetgen
