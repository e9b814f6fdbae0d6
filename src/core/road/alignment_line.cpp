#include "streetgen/alignment_line.hpp"

#include <algorithm>
#include <cmath>

#include "streetgen/cancel.hpp"

namespace streetgen {
namespace {

// Nearer vertices are one.
constexpr double least_chord = 1e-4;

void add_grade_abscissas(const std::vector<GradePiece>& grades, double tolerance,
                         std::vector<double>& abscissas) {
  for (const GradePiece& piece : grades) {
    const double length = piece.end_abscissa - piece.start_abscissa;
    const double chords = length * std::sqrt(std::abs(piece.bend) / (8 * tolerance));
    const int parts = std::max(1, static_cast<int>(std::ceil(chords)));
    for (int i = 0; i < parts; ++i) abscissas.push_back(piece.start_abscissa + length * i / parts);
  }
}

// The share of the whole offset after so many metres of the taper.
double taper_share(double metres, double taper) {
  const double t = taper > 0 ? std::clamp(metres / taper, 0.0, 1.0) : 1;
  return t * t * (3 - 2 * t);
}

void add_taper_abscissas(const LineOffset& beside, double length, std::vector<double>& abscissas) {
  constexpr int parts = 24;
  for (int i = 0; i <= parts && beside.taper > 0; ++i) {
    abscissas.push_back(beside.taper * i / parts);
    abscissas.push_back(length - beside.taper * i / parts);
  }
}

}  // namespace

Line alignment_line(const std::vector<AlignmentElement>& elements,
                    const std::vector<GradePiece>& grades, double from, double to, double tolerance,
                    LineOffset beside) {
  std::vector<double> abscissas = chord_abscissas(elements, tolerance);
  add_grade_abscissas(grades, tolerance, abscissas);
  const double length = alignment_length(elements);
  beside.taper = std::min(beside.taper, length / 2);
  if (beside.offset != 0) add_taper_abscissas(beside, length, abscissas);
  from = std::clamp(from, 0.0, length);
  to = std::clamp(to, from, length);
  std::sort(abscissas.begin(), abscissas.end());
  std::vector<double> kept{from};
  for (double s : abscissas)
    if (s > kept.back() + least_chord && s < to - least_chord) kept.push_back(s);
  kept.push_back(to);
  Line line;
  for (double s : kept) {
    poll_cancel();
    const AlignmentPlace place = alignment_place(elements, s);
    const double offset = beside.offset * taper_share(std::min(s, length - s), beside.taper);
    Point point = place.point;
    point.x -= offset * std::sin(place.heading);
    point.y += offset * std::cos(place.heading);
    point.z = grades.empty() ? 0 : grade_place(grades, s).height;
    line.push_back(point);
  }
  return line;
}

}  // namespace streetgen
