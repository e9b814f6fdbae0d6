// The faces of a network: what its edges enclose, and the sides of edges about each face.
#pragma once

#include <vector>

#include "geometry/arrangement.hpp"
#include "streetgen/geometry.hpp"
#include "streetgen/network.hpp"

namespace streetgen {

// All around one border of a face, with the face on its left.  It begins at its smallest place, by
// edge, part, and left before right.
struct FaceRing {
  std::vector<EdgeSide> sides;  // of edges that lie on each other all
  Ring line;                    // closed; a dead end is walked to its end and back
};

struct Face {
  // Counter-clockwise about the face, then clockwise about each island within: edges that hang
  // together, but not with those about the face. Such an island may be a line without an area.
  std::vector<FaceRing> rings;
  double area = 0;  // square metres, without the islands
};

struct NetworkFaces {
  std::vector<Face> faces;        // each positive in area, in the order of their smallest places
  std::vector<FaceRing> outside;  // about all that lies in no face
};

// The faces of lines that are edges: all of one level.  Where two cross or touch is a vertex, node
// or not.  A line of less than two distinct points has no side.  Lines are noded on a grid finer
// than a tenth of a micrometre; what is nearer is one place.  The cost is that of sorting the
// segments, and of comparing those that a line across the network meets.
NetworkFaces find_faces(const std::vector<LineView>& edges);

// The faces of the edges of one level, by their numbers in the network.
NetworkFaces find_faces(const Network& network, int level);

}  // namespace streetgen
