// One surface cut along the boundary of another.
#pragma once

#include <optional>

#include "streetgen/geometry.hpp"

namespace streetgen {

struct Cut {
  MultiPolygon shared;  // what both cover
  MultiPolygon rest;    // what only the first covers
};

// Of valid surfaces.  Vertices nearer than a tenth of a micrometre to each other or to a segment
// are taken to lie on it, so that a border made in two ways is one; where two crossings lie so near
// to each other, or the areas do not add up, nothing: a general overlay is needed then.  Where the
// surface nearly touches itself a part may be invalid.  Every coordinate is one of the surfaces'
// own or of a crossing of their segments.  Time grows with the product of their vertices.
std::optional<Cut> cut(const MultiPolygon& surface, const MultiPolygon& by);

}  // namespace streetgen
