// The middle of two dual carriageways that cross: ground between four one-way edges.
#pragma once

#include <vector>

#include "roadway/street_face.hpp"

namespace streetgen {

// Whether traffic runs along all four sides of a small face, or against all, opposite sides are
// nearly parallel, and both streets go on as pairs of one-way edges, farther than they lie apart:
// one at both ends, the other at one end at least. A block of a grid of one-way streets is none,
// nor is the island of a ring, which its source names, or whose sides bend. The nodes at the face's
// corners note in Junction::followed which nodes it looked at.
bool is_middle_of_crossing(Layout& layout, const StreetFace& face);

// What the node at a corner of the face has of its ground, between the middles of two sides, and
// how far that reaches along both edges, metres.
struct MiddlePart {
  Polygon ground;
  double limit_a = 0, limit_b = 0;
};

// By corner; none where the kerbs leave no ground.
std::vector<MiddlePart> parts_of_middle(const Layout& layout, const StreetFace& face);

}  // namespace streetgen
