// Gauss-Legendre quadrature of 24 points on the unit interval.
#pragma once

#include <array>

namespace streetgen {

struct QuadraturePoint {
  double at, weight;  // 0 < at < 1; the weights sum to 1
};

const std::array<QuadraturePoint, 24>& quadrature();

}  // namespace streetgen
