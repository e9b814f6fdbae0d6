// An axis as the fit sees it: vertices that may move, and numbers that may change.
#pragma once

#include <vector>

#include "streetgen/fit.hpp"

namespace streetgen {

constexpr int not_free = -1;

struct CourseVertex {
  Point origin;
  double abscissa = 0;  // metres along the axis of the input
  int x = not_free;     // the first of its two unknowns
};

struct Course {
  std::vector<CourseVertex> vertices;
  double total = 0;  // metres
  // Unknowns; the end goes with the start where the width does not change more than before.
  int width_start = not_free, width_end = not_free, offset = not_free;
};

// The unknowns of all axes, with their bounds.
struct Unknowns {
  std::vector<Course> courses;
  std::vector<double> origin, least, greatest;

  int add(double value, double lower, double upper);
  int count() const { return static_cast<int>(origin.size()); }
};

// Vertices of each axis: those of its line, and where axes move also its nodes, and places no
// farther apart than a piece.
Unknowns vertices_of(const std::vector<FitAxis>& axes, const FitRules& rules);

// Adds the unknown widths and offsets of the axes that take kerbs. Tells of each axis whether its
// width may change along it.
void add_widths(const std::vector<FitAxis>& axes, const std::vector<bool>& taken,
                const std::vector<bool>& tapers, const FitRules& rules, Unknowns& unknowns);

// An axis with the values of its unknowns.
class FittedCourse {
 public:
  FittedCourse(const FitAxis& axis, const Course& course, const std::vector<double>& values)
      : axis_(axis), course_(course), values_(values) {}
  Point vertex(std::size_t i) const;
  double width_start() const { return of(course_.width_start, axis_.width_start); }
  double width_end() const;
  double offset() const { return of(course_.offset, axis_.roadway_offset); }
  double width(double abscissa) const {
    return width_start() + (width_end() - width_start()) * abscissa / course_.total;
  }
  // Metres from the axis to the kerb of a side: +1 left, -1 right.
  double to_kerb(double abscissa, int side) const { return width(abscissa) / 2 + side * offset(); }

 private:
  double of(int unknown, double input) const {
    return unknown == not_free ? input : values_[unknown];
  }
  const FitAxis& axis_;
  const Course& course_;
  const std::vector<double>& values_;
};

}  // namespace streetgen
