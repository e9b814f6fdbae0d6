#include "road/quadrature.hpp"

#include <cmath>

namespace streetgen {
namespace {

struct Legendre {
  double value, slope;
};

// The Legendre polynomial of degree n and its derivative, by the recurrence of three terms.
Legendre legendre(int n, double x) {
  double before = 1, value = x;
  for (int k = 2; k <= n; ++k) {
    const double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
    before = value;
    value = next;
  }
  return {value, n * (x * value - before) / (x * x - 1)};
}

std::array<QuadraturePoint, 24> make_quadrature() {
  constexpr int n = 24;
  std::array<QuadraturePoint, n> points;
  for (int i = 0; i < n; ++i) {
    double x = std::cos(M_PI * (i + 0.75) / (n + 0.5));
    for (int step = 0; step < 8; ++step) {
      const Legendre p = legendre(n, x);
      x -= p.value / p.slope;
    }
    const double slope = legendre(n, x).slope;
    points[i] = {(1 - x) / 2, 1 / ((1 - x * x) * slope * slope)};
  }
  return points;
}

}  // namespace

const std::array<QuadraturePoint, 24>& quadrature() {
  static const std::array<QuadraturePoint, 24> points = make_quadrature();
  return points;
}

}  // namespace streetgen
