// The residuals of a fit, with their slopes by the unknowns.
#pragma once

#include <array>
#include <vector>

#include "fit/loss.hpp"
#include "fit/match.hpp"

namespace streetgen {

// One residual, times its factor; what it depends on, at most ten unknowns.
struct Residual {
  double value = 0;
  double weight = 1;  // counts so many times
  Loss loss;
  int count = 0;
  std::array<int, 10> unknown;
  std::array<double, 10> slope;

  void depends(int on, double by) {
    if (on == not_free || by == 0) return;
    unknown[count] = on;
    slope[count++] = by;
  }
  double cost() const { return weight * loss.cost(value); }
};

// That of an observation at the place that it is matched to; none where nothing takes it, or where
// it lies on the right side.
bool residual_of(const Observation& observation, const FitMatch& match, const FitAxis& axis,
                 const Course& course, const std::vector<double>& values, const FitRules& rules,
                 double scale, Residual& residual);

// Hands each regulariser to `use`.
template <class Use>
void each_regulariser(const std::vector<FitAxis>& axes, const Unknowns& unknowns,
                      const std::vector<double>& values, const FitRules& rules, Use use);

// The length between two neighbouring vertices, and the angle at a vertex, against those of the
// input.
Residual spacing_residual(const FitAxis& axis, const Course& course, std::size_t segment,
                          const std::vector<double>& values, const FitRules& rules);
Residual angle_residual(const FitAxis& axis, const Course& course, std::size_t vertex,
                        const std::vector<double>& values, const FitRules& rules);

template <class Use>
void each_regulariser(const std::vector<FitAxis>& axes, const Unknowns& unknowns,
                      const std::vector<double>& values, const FitRules& rules, Use use) {
  const Loss soft{FitLoss::soft_l1, rules.scale};
  const auto hold = [&](int unknown, double factor, double weight = 1) {
    Residual residual;
    residual.loss = soft;
    residual.weight = weight;
    residual.value = factor * (values[unknown] - unknowns.origin[unknown]);
    residual.depends(unknown, factor);
    use(residual);
  };
  std::vector<bool> held(unknowns.count(), false);
  for (std::size_t a = 0; a < axes.size(); ++a) {
    const Course& course = unknowns.courses[a];
    // Both ends of a width that may change along the axis count as one that may not.
    if (course.width_end != course.width_start) {
      hold(course.width_start, rules.width, 0.5);
      hold(course.width_end, rules.width, 0.5);
    } else if (course.width_start != not_free) {
      hold(course.width_start, rules.width);
    }
    if (course.offset != not_free) hold(course.offset, rules.origin);
    for (std::size_t i = 0; i < course.vertices.size(); ++i) {
      const int x = course.vertices[i].x;
      if (x != not_free && !held[x]) {  // of a node once, whatever axes meet there
        held[x] = true;
        hold(x, rules.origin);
        hold(x + 1, rules.origin);
      }
      if (!rules.axes_move || i == 0) continue;
      use(spacing_residual(axes[a], course, i - 1, values, rules));
      if (i + 1 < course.vertices.size()) use(angle_residual(axes[a], course, i, values, rules));
    }
  }
}

}  // namespace streetgen
