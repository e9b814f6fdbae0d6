#include "value/alignment_numbers.hpp"

namespace streetgen::pg {

std::vector<AlignmentElement> elements_of(const NumberArray& array) {
  const std::vector<double> numbers = read_numbers(array, 7, "elements");
  std::vector<AlignmentElement> elements;
  for (std::size_t i = 0; i < numbers.size(); i += 7) {
    const double* n = &numbers[i];
    if (!(n[4] >= 0))
      throw Error(ErrorKind::invalid_input,
                  "the length of element " + std::to_string(i / 7 + 1) + " is " + text_of(n[4]));
    elements.push_back({n[0], {n[1], n[2], 0}, n[3], n[4], n[5], n[6]});
  }
  return elements;
}

std::vector<GradePoint> grade_points_of(const NumberArray& array) {
  const std::vector<double> numbers = read_numbers(array, 3, "grades");
  std::vector<GradePoint> points;
  for (std::size_t i = 0; i < numbers.size(); i += 3)
    points.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  return points;
}

}  // namespace streetgen::pg
