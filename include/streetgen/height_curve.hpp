// Heights along a road as cubic polynomials, as OpenDRIVE has them.
#pragma once

#include <vector>

namespace streetgen {

// Height a + b ds + c ds^2 + d ds^3, metres, of the place ds metres behind station s.
struct HeightPiece {
  double s = 0, a = 0, b = 0, c = 0, d = 0;
};

// The fewest polynomials that pass each of the heights at increasing stations by `tolerance` metres
// at most, with no break of grade.  Where heights would be left by more than that between two stations
// for a break to vanish, the break stays.  A parabola or a straight grade that is given by its
// points is one piece.  Fewer than two stations: no piece.
std::vector<HeightPiece> height_curve(const std::vector<double>& stations,
                                      const std::vector<double>& heights, double tolerance);

}  // namespace streetgen
