// The radii of the bends of a polyline.
#pragma once

#include <optional>
#include <vector>

namespace streetgen {

struct Bend {
  double tangent = 0;           // of half the turn: an arc takes radius * tangent of both segments
  double bound = 0;             // greatest radius
  std::optional<double> fixed;  // comes before the bound
};

// The tangent of half a turn, from its sine (positive) and cosine.
double half_turn_tangent(double sine, double cosine);

// The radius of an arc that leaves the corner of a bend by `shift`; tangent: of half the turn.
double radius_of_shift(double tangent, double shift);

// The lexicographically greatest radii, ascending: all radii grow together, and those stop that
// fill a segment or reach their bound. lengths.size() == bends.size() + 1.
std::vector<double> fit_radii(const std::vector<double>& lengths, const std::vector<Bend>& bends);

}  // namespace streetgen
