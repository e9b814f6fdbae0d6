// The cost of a residual, and its weight in the next round of least squares.
#pragma once

#include <cmath>

#include "streetgen/fit.hpp"

namespace streetgen {

struct Loss {
  FitLoss kind = FitLoss::squares;
  double scale = 1;

  double cost(double residual) const {
    const double square = residual / scale * (residual / scale);
    if (kind == FitLoss::cauchy) return scale * scale * std::log1p(square);
    if (kind == FitLoss::soft_l1) return 2 * scale * scale * (std::sqrt(1 + square) - 1);
    return residual * residual;
  }

  // Half of the slope of the cost over the residual.
  double weight(double residual) const {
    const double square = residual / scale * (residual / scale);
    if (kind == FitLoss::cauchy) return 1 / (1 + square);
    if (kind == FitLoss::soft_l1) return 1 / std::sqrt(1 + square);
    return 1;
  }
};

}  // namespace streetgen
