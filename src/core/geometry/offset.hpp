// The borders of an axis as pieces: one segment per segment, one arc per outer bend.
#pragma once

#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

struct OffsetPiece {
  Point start, end;  // of the piece
  Point centre;      // of an arc: the axis vertex
  bool arc = false;
  double start_abscissa = 0, end_abscissa = 0;  // on the axis
  std::size_t segment = 0;                      // of the axis; of an arc the one after its vertex
};

// `side` +1: left, -1: right; `offset` >= 0 metres.  Raw: parts nearer to the axis than
// `offset` are not yet removed.
std::vector<OffsetPiece> offset_pieces(const Line& axis, double offset, int side);

struct KerbLine {
  Line line;
  bool whole = true;  // false: an inner bend needs more than its segments are long
};

// The kerb between abscissas u and v (backwards when u > v), half widths linear from
// `half_start` at abscissa 0 to `half_end` at the end of the axis; a negative one lies on the
// other side.  Inner bends are mitred.
KerbLine kerb_line(const Line& axis, double u, double v, double half_start, double half_end,
                   int side);

// The line at a signed offset (left of the axis positive, linear from abscissa 0 to the end of the
// axis) from abscissa u to v, u < v: mitred in inner bends, round about outer ones; where an inner
// bend needs more than its segments are long, what lies nearer to the axis is cut out.
Line offset_line(const Line& axis, double u, double v, double offset_start, double offset_end);

}  // namespace streetgen
