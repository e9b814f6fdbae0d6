// Straight pieces of axes.
#pragma once

#include <vector>

#include "box_runs.hpp"
#include "overlap.hpp"
#include "streetgen/geometry.hpp"

namespace streetgen {

// Metres along its line.  The ends are points of their own: pieces that go on from each other have
// one in common to the last bit.
struct Straight {
  Point origin, along;  // unit
  double from = 0, to = 0;
  Point start, end;

  Box box() const { return box_of(start, end); }
  double square_from(const Point& p) const;
};

struct Range {
  double from, to;

  bool empty() const { return !(from < to); }
  // Leaves where start + slope t lies between these.
  void hold(double start, double slope, double least, double most);
};

// The pieces of the line between two abscissas, as seen from an origin near them: there they end
// where they end, and not where coordinates of a city are rounded to.
void append_pieces(const Line& line, double from, double to, const Point& origin,
                   std::vector<Straight>& pieces);

// What of the pieces does not lie on others, to a tenth of a millimetre.
std::vector<Straight> apart(const std::vector<Straight>& pieces,
                            const std::vector<Straight>& others, const BoxRuns& boxes_of_others);

}  // namespace streetgen
