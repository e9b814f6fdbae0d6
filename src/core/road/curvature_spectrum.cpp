#include <algorithm>
#include <cmath>
#include <complex>
#include <string>

#include "geometry/polyline.hpp"
#include "streetgen/alignment.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"

namespace streetgen {
namespace {

constexpr std::size_t smoothed_over = 7;

std::vector<Point> places_every(const Line& line, double step) {
  std::vector<Point> places{line.front()};
  double missing = step;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point& a = line[i - 1];
    const double x = line[i].x - a.x, y = line[i].y - a.y, length = std::hypot(x, y);
    double at = missing;
    for (; at <= length; at += step)
      places.push_back({a.x + at / length * x, a.y + at / length * y, 0});
    missing = at - length;
  }
  return places;
}

// Headings of the chords without jumps of a full turn, smoothed by the mean of seven.
std::vector<double> smooth_headings(const std::vector<Point>& places) {
  std::vector<double> headings;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double heading = std::atan2(places[i].y - places[i - 1].y, places[i].x - places[i - 1].x);
    headings.push_back(headings.empty()
                           ? heading
                           : headings.back() + std::remainder(heading - headings.back(), 2 * M_PI));
  }
  std::vector<double> smooth;
  for (std::size_t i = 0; i + smoothed_over <= headings.size(); ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < smoothed_over; ++k) sum += headings[i + k];
    smooth.push_back(sum / smoothed_over);
  }
  return smooth;
}

std::size_t band_of(double cycles_per_km) {
  for (std::size_t band = 0; band < 4; ++band)
    if (cycles_per_km < std::pow(2, static_cast<double>(band))) return band;
  return 4;
}

// Energy of a window in each band, by the sums of the discrete Fourier transform.
std::vector<double> window_energy(const double* curvature, std::size_t n, double step) {
  std::vector<double> energy(5, 0);
  for (std::size_t k = 1; k <= n / 2; ++k) {
    std::complex<double> sum = 0;
    const std::complex<double> turn = std::polar(1.0, -2 * M_PI * static_cast<double>(k) / n);
    std::complex<double> at = 1;
    for (std::size_t i = 0; i < n; ++i, at *= turn)
      sum += curvature[i] * (0.5 - 0.5 * std::cos(2 * M_PI * (i + 0.5) / n)) * at;
    energy[band_of(1000 * k / (n * step))] += std::norm(sum);
  }
  return energy;
}

}  // namespace

std::vector<double> curvature_spectrum(const Line& line, double step, double extent) {
  if (!(step >= 0.01 && step <= 1000))
    throw Error(ErrorKind::invalid_input, "step is " + text_of(step) + " m",
                "Expected 0.01 to 1000.");
  if (!(extent >= 16 * step && extent <= 1e5 * step))
    throw Error(ErrorKind::invalid_input, "extent is " + text_of(extent) + " m",
                "Expected 16 to 100000 steps.");
  const std::vector<double> headings = smooth_headings(places_every(line, step));
  std::vector<double> curvature;
  for (std::size_t i = 1; i < headings.size(); ++i)
    curvature.push_back((headings[i] - headings[i - 1]) / step);
  const std::size_t n = static_cast<std::size_t>(extent / step);
  std::vector<double> shares(5, 0);
  int windows = 0;
  for (std::size_t first = 0; first + n <= curvature.size(); first += n / 2) {
    poll_cancel();
    const std::vector<double> energy = window_energy(&curvature[first], n, step);
    double all = 0;
    for (double e : energy) all += e;
    if (!(all > 1e-20)) continue;
    for (std::size_t band = 0; band < 5; ++band) shares[band] += energy[band] / all;
    ++windows;
  }
  if (windows == 0) return {};
  for (double& share : shares) share /= windows;
  return shares;
}

}  // namespace streetgen
