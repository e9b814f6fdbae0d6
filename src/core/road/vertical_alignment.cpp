#include "streetgen/vertical_alignment.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "streetgen/error.hpp"

namespace streetgen {
namespace {

[[noreturn]] void refuse_grade_point(std::size_t i, const std::string& what,
                                     const std::string& hint) {
  throw Error(ErrorKind::invalid_input, "grade point " + std::to_string(i + 1) + what, hint);
}

std::vector<double> grades_of(const std::vector<GradePoint>& points) {
  std::vector<double> grades;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const GradePoint& p = points[i];
    if (!std::isfinite(p.abscissa) || !std::isfinite(p.height) || !(p.radius >= 0) ||
        !std::isfinite(p.radius))
      refuse_grade_point(i, " has a value that is not finite, or a radius below 0", "");
    if (i == 0) continue;
    const double run = p.abscissa - points[i - 1].abscissa;
    if (!(run > 1e-6))
      refuse_grade_point(i,
                         " at " + text_of(p.abscissa) + " m does not lie after the one before it",
                         "Grade points stand in the order of their abscissas.");
    grades.push_back((p.height - points[i - 1].height) / run);
  }
  return grades;
}

}  // namespace

std::vector<GradePiece> vertical_alignment(const std::vector<GradePoint>& points) {
  const std::vector<double> grades = grades_of(points);
  std::vector<GradePiece> pieces;
  double from = points.empty() ? 0 : points[0].abscissa;
  for (std::size_t i = 0; i < grades.size(); ++i) {
    const GradePoint& next = points[i + 1];
    const bool last = i + 1 == grades.size();
    const double change = last ? 0 : grades[i + 1] - grades[i];
    const double tangent = next.radius * std::abs(change) / 2;
    const double to = next.abscissa - tangent;
    if (to < from - 1e-6)
      refuse_grade_point(i + 1, ": its parabola overlaps the one before it",
                         "Make the radii smaller, or move the points apart.");
    const double height = points[i].height + grades[i] * (from - points[i].abscissa);
    if (to > from) pieces.push_back({from, to, height, grades[i], 0});
    from = std::max(from, to);
    if (tangent > 0) {
      pieces.push_back({from, next.abscissa + tangent,
                        points[i].height + grades[i] * (from - points[i].abscissa), grades[i],
                        std::copysign(1 / next.radius, change)});
      from = next.abscissa + tangent;
    }
  }
  return pieces;
}

GradePlace grade_place(const std::vector<GradePiece>& pieces, double abscissa) {
  if (pieces.empty()) throw Error(ErrorKind::invalid_input, "there are no grades");
  const auto after =
      std::upper_bound(pieces.begin(), pieces.end(), abscissa,
                       [](double s, const GradePiece& p) { return s < p.start_abscissa; });
  const GradePiece& piece = after == pieces.begin() ? pieces.front() : after[-1];
  const double t = abscissa - piece.start_abscissa;
  return {piece.height + (piece.grade + piece.bend * t / 2) * t, piece.grade + piece.bend * t};
}

}  // namespace streetgen
