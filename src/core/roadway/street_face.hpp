// Ground that edges of one level enclose, seen from its corners.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "layout/layout.hpp"

namespace streetgen {

struct CornerPlace {
  int node = 0;
  std::size_t gap = 0;  // index in Junction::ends of its first arm
  bool operator==(const CornerPlace& o) const { return node == o.node && gap == o.gap; }
};

// An edge along a face, on its left, and the corner that it leads away from.
struct FaceSide {
  EdgeEnd end;
  CornerPlace corner;
};

// Counter-clockwise about its ground.
using StreetFace = std::vector<FaceSide>;

// The faces smaller than island_area all of which lies within reach of each of their nodes. Each
// corner adds the nodes that it looked at to Junction::followed: its face may once have been small,
// or become so.
std::vector<StreetFace> small_faces(Layout& layout);

// The corner from which an edge leads along a face on its left.
CornerPlace corner_beside(const Layout& layout, const EdgeEnd& end);
// The next side of the same face, and the one before it.
FaceSide side_after(const Layout& layout, const FaceSide& side);
FaceSide side_before(const Layout& layout, const FaceSide& side);
// The face at a corner, counter-clockwise about an inner one; none where a part of it lies beyond
// reach of one of its nodes.
StreetFace face_about(const Layout& layout, const CornerPlace& corner);
// The face beside the first side from a corner; none where a part of it lies beyond reach of that
// side, so that a long side knows a longer face than a short one.
StreetFace face_beside(const Layout& layout, const CornerPlace& corner);
bool on_one_level(const Layout& layout, const StreetFace& face);

// The row of a corner, once corners are solved.
Corner& corner_row(Layout& layout, const CornerPlace& corner);

// The node at the other end.
int far_node(const Layout& layout, const EdgeEnd& end);
// The line of the edges about a face.
Ring ring_of(const Layout& layout, const StreetFace& face);

// Where the flat kerbs cross.
std::optional<CornerArc> kerb_crossing(const Layout& layout, const CornerPlace& corner);
// By corner of the face.
using KerbCrossings = std::vector<std::optional<CornerArc>>;
KerbCrossings kerb_crossings(const Layout& layout, const StreetFace& face);
// A stretch of a side's left kerb, by abscissas from its corner.
struct KerbStretch {
  double from = 0, until = 0;
};
// From crossing to crossing, by side; none where kerbs leave no ground between.
std::vector<KerbStretch> kerbs_about(const Layout& layout, const StreetFace& face,
                                     const KerbCrossings& crossings);

}  // namespace streetgen
