// A line that leaves kerbs which follow each other, on their left, everywhere at one speed.
#pragma once

#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

// Between sides that face each other more than they follow each other.
constexpr double facing_cosine = -0.5;

// A straight piece of a kerb, and how wide the strip behind it is at its two ends.
struct KerbSegment {
  Point from, to;  // distinct
  double width_from = 0, width_to = 0;
  int kerb = 0;  // that it belongs to: consecutive ones for consecutive segments
  Point along;   // unit vector, of all the straight piece of kerb that it is part of
};

// What the front passes behind one kerb.
struct KerbGround {
  // What bounds it beside the kerb before and the one after: from the kerb on, to where another
  // kerb lies behind it, or farther than any strip is wide.
  Line start, end;
  bool is_open = true;  // none lies behind it, as far as its strip is wide
  bool whole = true;    // otherwise the front cannot tell
  bool narrow = false;  // it meets the front of a kerb across
};

struct FrontPassed {
  std::vector<KerbGround> grounds;  // of each kerb from 0 on
  std::vector<bool> bounds_back;    // of each segment: the front has a side of it where it stops
};

// Where the front turns by less than a chord of a round bend, or inwards, its sides part at the
// bisector. About an outer bend it goes round, behind either kerb as far as the middle. A side that
// shrinks to nothing leaves its neighbours side by side. So each place belongs to the nearer of two
// kerbs, whichever way they are walked along.
//
// The segments follow each other, and on to the first one where the chain is closed. `before` and
// `after` are the directions of kerbs without strips that an open chain follows and leads to;
// zero: none.
FrontPassed pass_front(const std::vector<KerbSegment>& segments, bool is_closed,
                       const Point& before, const Point& after);

}  // namespace streetgen
